#include "core/edit/part_search.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/base/assert.h"

namespace kerf {

namespace {

// Returns the faces of all ties, each once, and sets `place` to the place of each in the list plus one.
std::vector<FaceId> faces_of(std::span<const std::pair<FaceId, FaceId>> ties, PagedArray<uint32_t>& place) {
  std::vector<FaceId> faces;
  const auto add = [&](FaceId f) {
    uint32_t& own = place.at(f.index);
    if (own != 0) return;
    faces.push_back(f);
    own = static_cast<uint32_t>(faces.size());
  };
  for (const auto& [removed, beside] : ties) {
    add(removed);
    add(beside);
  }
  return faces;
}

constexpr uint32_t kFrontierSamples = 64, kFaceSamples = 256;

// Returns the mean of corners of the frontier's live faces.
Vec3 middle_of(const Mesh& mesh, const SearchFront& front) {
  Vec3 sum(0);
  size_t count = 0;
  const size_t size = front.frontier.size() - front.next,
               stride = std::max<size_t>(size / kFrontierSamples, 1);
  for (size_t i = front.next; i < front.frontier.size(); i += stride) {
    const FaceId f = front.frontier[i].face;
    if (!mesh.is_live(f)) continue;
    sum += mesh.position(mesh.corners(f)[0]);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : sum;
}

constexpr size_t kMaxTurn = 128;  // maximum number of faces visited in one turn
constexpr size_t kLarge = 4096;   // minimum number of visited faces of a large front
constexpr size_t kHandicap = 4;   // factor of the visited faces of a likely larger front

}  // namespace

TieClusters::TieClusters(std::span<const std::pair<FaceId, FaceId>> ties, PagedArray<uint32_t>& scratch)
    : faces_(faces_of(ties, scratch)), clusters_(faces_.size()) {
  for (const auto& [removed, beside] : ties)
    clusters_.unite(scratch.get(removed.index) - 1, scratch.get(beside.index) - 1);
  for (const FaceId f : faces_) scratch.at(f.index) = 0;
}

uint32_t estimate_larger_front(const Body& body, uint32_t a, uint32_t b) {
  const OpenSearch& search = body.separation.search;
  const SearchFront &front_a = search.fronts[a], &front_b = search.fronts[b];
  KERF_ASSERT(!front_a.exhausted() && !front_b.exhausted());
  const Vec3 middle_a = middle_of(body.mesh, front_a), middle_b = middle_of(body.mesh, front_b);
  const FaceCounts* whole = &body.whole_of(search.seed[a]);
  const uint32_t stride = std::max(body.mesh.face_slots() / kFaceSamples, 1u);
  int nearer_a = 0;
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); slot += stride) {
    const FaceId f(slot);
    if (!body.mesh.is_live(f) || &body.whole_of(f) != whole) continue;
    const SearchFront* reached_by = search.front_of(f);
    const Vec3 at = body.mesh.position(body.mesh.corners(f)[0]);
    const Vec3 to_a = at - middle_a, to_b = at - middle_b;
    const bool of_a = reached_by ? reached_by == &front_a : glm::dot(to_a, to_a) < glm::dot(to_b, to_b);
    nearer_a += of_a ? 1 : -1;
  }
  return nearer_a > 0 ? a : b;
}

uint32_t PartSearch::root(std::vector<uint32_t>& parent, uint32_t x) {
  while (parent[x] != x) x = parent[x] = parent[parent[x]];
  return x;
}

// Beginning -------------------------------------------------------------------------------------------------

void PartSearch::start(Scope scope) {
  KERF_ASSERT(search_.stage == OpenSearch::Stage::kNone && search_.fronts.empty());
  search_.stage = OpenSearch::Stage::kGrow;
  if (scope == Scope::kClusters) {
    seed_clusters();
  } else {
    seed_components();
  }
  const size_t seeds = search_.seed.size();
  search_.group_parent.resize(seeds);
  std::iota(search_.group_parent.begin(), search_.group_parent.end(), 0u);
  search_.front_parent = search_.group_parent;
  search_.fronts.resize(seeds);
  KERF_ASSERT(search_.group.size() == seeds);
  for (uint32_t i = 0; i < seeds; ++i) reach(i, {search_.seed[i]});  // no two fronts meet: the seeds differ
}

// Starts a front at each live face of a tie, in the order of their slots; the group of a cluster has the
// number of its first front.
void PartSearch::seed_clusters() {
  TieClusters clusters(state_.ties, state_.tie_place);
  const auto faces = clusters.faces();
  std::vector<std::pair<FaceId, uint32_t>> seeds;  // with their clusters
  for (uint32_t i = 0; i < faces.size(); ++i) {
    if (body_.mesh.is_live(faces[i])) seeds.emplace_back(faces[i], clusters.cluster(i));
  }
  std::sort(seeds.begin(), seeds.end());
  std::vector<uint32_t> group_of(faces.size(), kNoIndex);
  search_.seed.clear();
  search_.group.clear();
  for (const auto& [face, cluster] : seeds) {
    uint32_t& group = group_of[cluster];
    if (group == kNoIndex) group = static_cast<uint32_t>(search_.seed.size());
    search_.seed.push_back(face);
    search_.group.push_back(group);
  }
}

void PartSearch::seed_components() {
  search_.seed.clear();
  for (const auto& tie : state_.ties) {
    if (body_.mesh.is_live(tie.second) && std::exchange(state_.tie_place.at(tie.second.index), 1) == 0)
      search_.seed.push_back(tie.second);
  }
  for (const FaceId f : search_.seed) state_.tie_place.at(f.index) = 0;
  std::sort(search_.seed.begin(), search_.seed.end());
  search_.group.resize(search_.seed.size());
  std::vector<std::pair<const FaceCounts*, uint32_t>> known;
  for (uint32_t i = 0; i < search_.seed.size(); ++i) {
    const FaceCounts* whole = &body_.whole_of(search_.seed[i]);
    const auto at = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.first == whole; });
    search_.group[i] = at != known.end() ? at->second : known.emplace_back(whole, i).second;
  }
}

bool PartSearch::continue_search(size_t most, SettleResult& result) {
  if (search_.stage == OpenSearch::Stage::kGrow && grow(most, result)) assign_labels(result);
  if (search_.stage == OpenSearch::Stage::kRelabel) relabel(most, result);
  return search_.stage == OpenSearch::Stage::kNone;
}

// Edits between steps ---------------------------------------------------------------------------------------

void PartSearch::record_replaced(const Replacement& replaced) {
  uint32_t mark = 0;  // the largest mark, i.e. that of a visited face if there is one
  for (int i = 0; i < replaced.removed_count; ++i)
    mark = std::max(mark, search_.mark.get(replaced.removed[i].index));
  if (mark == 0) return;
  for (int i = 0; i < replaced.removed_count; ++i) {
    const FaceId f = replaced.removed[i];
    const uint32_t own = search_.mark.get(f.index);
    if (mark & ~own & OpenSearch::kVisited) record_visited(f, own != 0 ? own : mark, half_of(replaced));
  }
  for (int i = 0; i < replaced.added_count; ++i) {
    uint32_t& own = search_.mark.at(replaced.added[i].index);
    if (own == 0) own = mark;
    revisit(replaced.added[i]);
  }
}

// Returns the area that each half of a green pair had before four faces of equal areas replaced the pair, of
// which some, but not all, may have been bisected already.
double PartSearch::half_of(const Replacement& replaced) const {
  KERF_ASSERT(replaced.removed_count == 2 && replaced.added_count == 4);
  double quarter = 0;
  for (const FaceId f : replaced.added) quarter = std::max(quarter, triangle_area(body_.mesh.triangle(f)));
  return 2 * quarter;
}

// Marks a face as visited. One half of a green pair may not have been visited when the pair was split.
void PartSearch::record_visited(FaceId f, uint32_t mark, double area) {
  assert((mark & ~OpenSearch::kVisited) != 0);
  search_.mark.at(f.index) = mark | OpenSearch::kVisited;
  SearchFront& front = *search_.front_of(f);
  ++front.faces;
  front.area += area;
}

// Assigns the neighbours of an unvisited removed face to the front that has reached the face, or has reached
// one of its neighbours without visiting it.
void PartSearch::record_removed_part(FaceId f) {
  if (search_.stage != OpenSearch::Stage::kGrow) return;
  uint32_t mark = search_.mark.get(f.index);
  if (mark & OpenSearch::kVisited) return;
  for (size_t i = 0; i < state_.neighbours.size() && mark == 0; ++i) {
    const uint32_t beside = search_.mark.get(state_.neighbours[i].index);
    if (!(beside & OpenSearch::kVisited)) mark = beside;
  }
  if (mark == 0) return;
  for (const FaceId n : state_.neighbours) reach(mark - 1, {n});
}

void PartSearch::record_flipped(FaceId f, double area_gained) {
  if (search_.stage == OpenSearch::Stage::kGrow && (search_.mark.get(f.index) & OpenSearch::kVisited) != 0)
    search_.front_of(f)->area += area_gained;
  revisit(f);
}

void PartSearch::revisit(FaceId f) {
  if (search_.stage != OpenSearch::Stage::kGrow) return;
  if (SearchFront* front = search_.front_of(f)) front->frontier.push_back({f});
}

// Growing ---------------------------------------------------------------------------------------------------

void PartSearch::reach(uint32_t front, const ReachedFace& reached) {
  const uint32_t mark = search_.mark.get(reached.face.index) & ~OpenSearch::kVisited;
  if (mark == 0) return reach_face(root(search_.front_parent, front), reached);
  if (mark != front + 1) merge(mark - 1, front);
}

// Precondition: `front` was not merged into another one, and no front has reached the face.
void PartSearch::reach_face(uint32_t front, const ReachedFace& reached) {
  assert(body_.mesh.is_live(reached.face));
  search_.mark.at(reached.face.index) = front + 1;
  SearchFront& own = search_.fronts[front];
  own.frontier.push_back(reached);
  own.lowest = std::min(own.lowest, reached.face.index);
}

// Merges two fronts that met, with their faces and groups. Linear in the smaller frontier.
void PartSearch::merge(uint32_t a, uint32_t b) {
  a = root(search_.front_parent, a);
  b = root(search_.front_parent, b);
  if (a == b) return;
  const uint32_t into = std::min(a, b), from = std::max(a, b);
  search_.front_parent[from] = into;
  unite_groups(search_.group[into], search_.group[from]);
  SearchFront &to = search_.fronts[into], &other = search_.fronts[from];
  if (to.frontier.size() - to.next < other.frontier.size() - other.next) {
    std::swap(to.frontier, other.frontier);
    std::swap(to.next, other.next);
  }
  to.frontier.insert(to.frontier.end(), other.frontier.begin() + static_cast<std::ptrdiff_t>(other.next),
                     other.frontier.end());
  to.visited += other.visited;
  to.faces += other.faces;
  to.area += other.area;
  to.lowest = std::min(to.lowest, other.lowest);
  to.compared = to.estimated_larger = false;
  other = SearchFront{};
  queue(into);
}

// Unites the groups of two fronts that met. Neither was exhausted, else it would have reached the other.
void PartSearch::unite_groups(uint32_t a, uint32_t b) {
  a = root(search_.group_parent, a);
  b = root(search_.group_parent, b);
  if (a != b) search_.group_parent[b] = a;
  if (open_.empty()) return;  // between two calls of settle(); the next one recounts open fronts
  if (a != b) open_[a] += open_[b];
  assert(open_[a] > 0);
  --open_[a];
}

// Recomputes the totals of the fronts, which edits since the last call may have changed.
void PartSearch::sum_up() {
  found_.clear();
  open_.assign(search_.group_parent.size(), 0);
  for (uint32_t i = 0; i < search_.fronts.size(); ++i) {
    if (search_.front_parent[i] != i) continue;
    if (search_.fronts[i].exhausted()) {
      record_exhausted(i);
    } else {
      ++open_[root(search_.group_parent, search_.group[i])];
      queue(i);
    }
  }
}

void PartSearch::record_exhausted(uint32_t front) {
  const SearchFront& own = search_.fronts[front];
  assert(own.exhausted());
  Found& found = found_of(front);
  found.faces += own.faces;
  found.area += own.area;
  found.largest = std::max(found.largest, own.area);
}

PartSearch::Found& PartSearch::found_of(uint32_t front) {
  const FaceCounts* whole = &body_.whole_of(search_.seed[front]);
  const auto known =
      std::find_if(found_.begin(), found_.end(), [&](const Found& f) { return f.whole == whole; });
  if (known != found_.end()) return *known;
  return found_.emplace_back(Found{whole});
}

// The last front of a component advances only if it may not be the largest part.
bool PartSearch::must_grow(uint32_t front) {
  if (open_[root(search_.group_parent, search_.group[front])] > 1) return true;
  const Found& found = found_of(front);
  return found.faces > 0 && !found.rest_is_largest();
}

size_t PartSearch::rank_of(uint32_t front) const {
  const SearchFront& own = search_.fronts[front];
  return own.visited * (compares_ && own.estimated_larger ? kHandicap : 1);
}

// Estimates which of the last two fronts of a component is the larger part, if `front` is one of them and
// both are large. Returns true if `front` must wait. Skips components with a part already found, in which the
// growth order of the last two fronts may affect the result.
bool PartSearch::compare(uint32_t front) {
  SearchFront& own = search_.fronts[front];
  if (!compares_ || own.compared || own.visited < kLarge) return false;
  if (found_of(front).faces > 0) return false;
  const uint32_t i = only_other(front);
  if (i == kNoIndex || search_.fronts[i].visited < kLarge) return false;
  own.compared = search_.fronts[i].compared = true;
  const uint32_t larger = estimate_larger_front(body_, front, i);
  search_.fronts[larger].estimated_larger = true;
  queue(larger);
  return larger == front;
}

// Returns the only other growing front of the same component; kNoIndex if there is none or more than one.
uint32_t PartSearch::only_other(uint32_t front) const {
  const FaceCounts* whole = &body_.whole_of(search_.seed[front]);
  uint32_t other = kNoIndex;
  for (uint32_t i = 0; i < search_.fronts.size(); ++i) {
    if (i == front || search_.front_parent[i] != i || search_.fronts[i].exhausted()) continue;
    if (&body_.whole_of(search_.seed[i]) != whole) continue;
    if (other != kNoIndex) return kNoIndex;
    other = i;
  }
  return other;
}

// Returns true if no front needs to advance.
bool PartSearch::grow(size_t most, SettleResult& result) {
  sum_up();
  while (!turns_.empty()) {
    if (result.visited >= most) return false;
    const Turn turn = turns_.top();
    turns_.pop();
    const uint32_t i = turn.front;
    if (search_.front_parent[i] != i || rank_of(i) != turn.rank) continue;  // outdated
    if (search_.fronts[i].exhausted() || !must_grow(i) || compare(i)) continue;
    result.visited += take_turn(i, std::clamp<size_t>(search_.fronts[i].visited / 32, 1, kMaxTurn));
  }
  return true;
}

// Finds the neighbours of all faces of the turn before reaching any of them, and prefetches data for the next
// turn, so that memory accesses overlap.
size_t PartSearch::take_turn(uint32_t front, size_t faces) {
  take_from(search_.fronts[front], faces);
  walk_.visit(turn_);
  const auto neighbours = walk_.neighbours();
  for (const ReachedFace& n : neighbours) search_.mark.prefetch(n.face.index);
  for (size_t at = 0; at < turn_.size(); ++at) {
    if (!walk_.is_live(at)) continue;
    const FaceId f = turn_[at].face;
    const uint32_t mark = search_.mark.get(f.index);
    if (!(mark & OpenSearch::kVisited)) record_visited(f, mark, walk_.area(at));
  }
  search_.fronts[front].visited += turn_.size();
  for (const ReachedFace& n : neighbours) reach(front, n);
  front = root(search_.front_parent, front);
  const SearchFront& own = search_.fronts[front];
  if (!own.exhausted()) {
    const std::span<const ReachedFace> ahead(own.frontier);
    walk_.prefetch(ahead.last(std::min(ahead.size() - own.next, kMaxTurn)));
    queue(front);
  } else {
    --open_[root(search_.group_parent, search_.group[front])];
    record_exhausted(front);
  }
  return turn_.size();
}

// Takes the oldest faces of the frontier, so that nearby fronts meet soon. A large front takes the newest
// ones, which are adjacent in memory.
void PartSearch::take_from(SearchFront& front, size_t faces) {
  assert(front.next <= front.frontier.size());
  faces = std::min(faces, front.frontier.size() - front.next);
  const auto taken = static_cast<std::ptrdiff_t>(faces);
  if (front.visited >= kLarge) {
    turn_.assign(front.frontier.end() - taken, front.frontier.end());
    front.frontier.resize(front.frontier.size() - faces);
  } else {
    const auto begin = front.frontier.begin() + static_cast<std::ptrdiff_t>(front.next);
    turn_.assign(begin, begin + taken);
    front.next += faces;
  }
}

}  // namespace kerf
