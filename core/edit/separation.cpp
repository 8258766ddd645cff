#include "core/edit/separation.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/base/assert.h"
#include "core/edit/part_search.h"

namespace kerf {

void PartSearch::assign_labels(SettleResult& result) {
  std::vector<uint32_t> came_off;
  for (const Found& found : found_) {
    std::vector<uint32_t> parts;
    for (uint32_t i = 0; i < search_.fronts.size(); ++i) {
      const SearchFront& front = search_.fronts[i];
      if (search_.front_parent[i] != i || !front.exhausted() || front.faces == 0) continue;
      if (&body_.whole_of(search_.seed[i]) == found.whole) parts.push_back(i);
    }
    if (found.rest_faces() == 0) drop_largest(parts);
    came_off.insert(came_off.end(), parts.begin(), parts.end());
  }
  std::sort(came_off.begin(), came_off.end(),
            [&](uint32_t a, uint32_t b) { return search_.fronts[a].lowest < search_.fronts[b].lowest; });
  search_.new_label.assign(search_.fronts.size(), 0);
  for (const uint32_t part : came_off) give_label(part, result);
  search_.stage = came_off.empty() ? OpenSearch::Stage::kNone : OpenSearch::Stage::kRelabel;
  if (came_off.empty()) return reset();
  for (uint32_t i = 0; i < search_.fronts.size(); ++i)
    search_.new_label[i] = search_.new_label[root(search_.front_parent, i)];
}

void PartSearch::drop_largest(std::vector<uint32_t>& parts) const {
  double largest = 0, whole = 0;
  for (const uint32_t part : parts) {
    largest = std::max(largest, search_.fronts[part].area);
    whole += search_.fronts[part].area;
  }
  const auto rank = [&](uint32_t part) {
    const SearchFront& front = search_.fronts[part];
    return std::pair(largest - front.area > kEqualArea * whole, front.lowest);
  };
  const auto stays =
      std::min_element(parts.begin(), parts.end(), [&](uint32_t a, uint32_t b) { return rank(a) < rank(b); });
  if (stays != parts.end()) parts.erase(stays);
}

// Transfers the counts at once; relabel() transfers the faces and their moments one by one.
void PartSearch::give_label(uint32_t part, SettleResult& result) {
  const SearchFront& front = search_.fronts[part];
  const FaceId seed = search_.seed[part];
  FaceCounts &old = body_.edit_piece_of(seed), &whole = body_.edit_whole_of(seed);
  for (FaceCounts* counts : {&old, &whole}) {
    KERF_ASSERT(counts->faces >= front.faces);
    counts->faces -= front.faces;
    counts->area -= front.area;
    if (&old == &whole) break;
  }
  search_.new_label[part] = body_.pieces.size();
  result.new_pieces.push_back(search_.new_label[part]);
  body_.pieces.push_back({{front.faces, front.area}, {}, {front.faces, front.area}});
}

// Relabels faces in slot order, and ends the search when all have their labels.
void PartSearch::relabel(size_t most, SettleResult& result) {
  const bool complete = find_unlabelled(most - std::min(most, result.relabelled.size()));
  moved_from_.clear();
  const size_t first = result.relabelled.size();
  for (const FaceId f : unlabelled_) {
    const uint32_t label = search_.label_to_be(f);
    if (body_.mesh.data(f).piece == label) continue;  // already labelled with the other half of its pair
    if (body_.mesh.data(f).element == FaceData::kNoElement) {
      assign_label(f, label, result);
      continue;
    }
    // Relabels both halves of a green pair at once: the faces that replace the pair take area from both.
    const OneToFour::Element pair = body_.refinement.element(body_.mesh, f);
    for (int i = 0; i < pair.face_count; ++i) assign_label(pair.faces[i], label, result);
  }
  move_moments(std::span(result.relabelled).subspan(first));
  if (!complete) return;
  search_.stage = OpenSearch::Stage::kNone;
  reset();
}

void PartSearch::assign_label(FaceId f, uint32_t label, SettleResult& result) {
  moved_from_.push_back(std::exchange(body_.mesh.edit_data(f).piece, label));
  result.relabelled.push_back(f);
}

// Moves the moments of relabelled faces from their former pieces.
void PartSearch::move_moments(std::span<const FaceId> faces) {
  KERF_ASSERT(moved_from_.size() == faces.size());
  const std::span<const Triangle> triangles = walk_.triangles(faces);
  const Vec3 origin = body_.middle();
  AreaMoments *left = nullptr, *gained = nullptr;
  uint32_t from = kNoIndex, to = kNoIndex;
  for (size_t i = 0; i < faces.size(); ++i) {
    const uint32_t label = body_.mesh.data(faces[i]).piece;
    if (moved_from_[i] != from) left = &body_.pieces.edit(from = moved_from_[i]).moments;
    if (label != to) gained = &body_.pieces.edit(to = label).moments;
    const AreaMoments moments = area_moments(triangles[i], triangle_area(triangles[i]), origin);
    *left -= moments;
    *gained += moments;
  }
}

// Sets `unlabelled_` to at most `most` faces without their label. Returns true if they are the last.
bool PartSearch::find_unlabelled(size_t most) {
  constexpr uint32_t kPage = PagedArray<uint32_t>::kPage;
  unlabelled_.clear();
  for (uint32_t& next = search_.next_slot; next < search_.mark.end();) {
    const uint32_t* marks = search_.mark.page(next);
    const uint32_t page_end = next - next % kPage + kPage;
    if (marks == nullptr) next = page_end;
    for (; next < page_end; ++next) {
      const uint32_t label = search_.label_of(marks[next % kPage]);
      if (label == 0) continue;
      const FaceId f(next);
      if (!body_.mesh.is_live(f) || body_.mesh.data(f).piece == label) continue;
      if (unlabelled_.size() >= most) return false;
      unlabelled_.push_back(f);
    }
  }
  return true;
}

void PartSearch::reset() {
  search_.mark.clear();
  search_.fronts.clear();
  search_.new_label.clear();
  search_.next_slot = 0;
}

void CutLoops::remove(FaceId f) {
  assert(mesh_.is_live(f));
  const Edges edges = edges_of(f);
  state_.over_rings |= edges.others;
  state_.is_inconclusive |= edges.others && state_.neighbours.size() > 1;
  const auto c = mesh_.corners(f);
  for (const VertexId v : c) meet(v);
  const int joined = int{unite(c[0], c[1])} + int{unite(c[1], c[2])};
  const int more = edges.shared - 1 - joined;
  state_.loops += more;
  if (more > 0) state_.any_closed = true;
}

CutLoops::Edges CutLoops::edges_of(FaceId f) const {
  Edges edges;
  std::array<bool, 3> found{};
  const auto c = mesh_.corners(f);
  for (const FaceId n : state_.neighbours) {
    const auto d = mesh_.corners(n);
    bool beside = false;
    for (size_t i = 0; i < 3 && !beside; ++i) {
      for (size_t k = 0; k < 3 && !found[i] && !beside; ++k)
        beside = found[i] = c[i] == d[(k + 1) % 3] && c[(i + 1) % 3] == d[k];
    }
    edges.shared += beside;
    edges.others |= !beside;
  }
  return edges;
}

void CutLoops::meet(VertexId v) {
  if (state_.joined.get(v.index) == 0) meet_along_rim(v);
}

// Traverses the boundary edges connected with v and unites their vertices.
void CutLoops::meet_along_rim(VertexId v) {
  state_.joined.at(v.index) = v.index + 1;
  state_.rim.assign(1, v);
  while (!state_.rim.empty()) {
    const VertexId at = state_.rim.back();
    state_.rim.pop_back();
    mesh_.star(at, state_.star);
    for (const VertexId next : state_.star.rim) {
      if (state_.joined.get(next.index) == 0) {
        state_.joined.at(next.index) = next.index + 1;
        state_.rim.push_back(next);
      }
      unite(at, next);
    }
  }
}

uint32_t CutLoops::find(VertexId v) {
  uint32_t x = v.index;
  for (;;) {
    assert(state_.joined.get(x) != 0);
    const uint32_t parent = state_.joined.get(x) - 1;
    if (parent == x) return x;
    const uint32_t above = state_.joined.get(parent);
    if (above != parent + 1) state_.joined.at(x) = above;
    x = parent;
  }
}

bool CutLoops::unite(VertexId a, VertexId b) {
  uint32_t x = find(a), y = find(b);
  if (x == y) return false;
  if (y < x) std::swap(x, y);
  state_.joined.at(y) = x + 1;
  return true;
}

namespace {

// Returns the number of components removed entirely: clusters of removed faces without a live face.
int64_t vanished_components(const Mesh& mesh, SeparationState& state) {
  KERF_ASSERT(state.first_tie <= state.ties.size());
  TieClusters clusters(std::span(state.ties).subspan(state.first_tie), state.tie_place);
  const auto faces = clusters.faces();
  std::vector<bool> lives(faces.size());
  for (uint32_t i = 0; i < faces.size(); ++i) {
    if (mesh.is_live(faces[i])) lives[clusters.cluster(i)] = true;
  }
  int64_t vanished = 0;
  for (uint32_t i = 0; i < faces.size(); ++i) vanished += clusters.cluster(i) == i && !lives[i];
  return vanished;
}

bool may_be_separated(const Mesh& mesh, SeparationState& state) {
  if (state.is_inconclusive || (state.over_rings && state.any_closed)) return true;
  // A face without neighbours was the last one of a component, or of a few faces that earlier removals had
  // enclosed; that loop is included in the sum.
  if (state.loops + state.alone <= 0) return false;
  return state.loops + vanished_components(mesh, state) > 0;
}

void start_step(SeparationState& state) {
  state.first_tie = state.ties.size();
  state.loops = state.alone = 0;
  state.any_closed = state.over_rings = state.is_inconclusive = false;
}

}  // namespace

void record_removed_part(Body& body, FaceId f) {
  KERF_ASSERT(body.mesh.is_live(f));
  SeparationState& state = body.separation;
  state.neighbours.clear();
  body.mesh.append_nearest_neighbours(f, state.neighbours);
  for (const FaceId n : state.neighbours) state.ties.emplace_back(f, n);
  if (state.neighbours.empty()) {
    ++state.alone;
    state.ties.emplace_back(f, f);
  }
  CutLoops(body.mesh, state).remove(f);
  if (!is_settled(body)) PartSearch(body).record_removed_part(f);
}

void record_replaced(Body& body, const Replacement& replaced) {
  if (!is_settled(body)) PartSearch(body).record_replaced(replaced);
}

void record_flipped(Body& body, FaceId f, double area_gained) {
  KERF_ASSERT(body.mesh.is_live(f));
  if (!is_settled(body)) PartSearch(body).record_flipped(f, area_gained);
}

SettleResult settle(Body& body, size_t most, EditPolicy policy) {
  SeparationState& state = body.separation;
  SettleResult result;
  PartSearch search(body, policy);
  bool& again = state.search.restart_requested;
  if (may_be_separated(body.mesh, state)) {
    if (is_settled(body)) {
      search.start(PartSearch::Scope::kClusters);
    } else {
      again = true;
    }
  }
  while (!is_settled(body)) {
    if (state.search.stage == OpenSearch::Stage::kNone) {
      again = false;
      search.start(PartSearch::Scope::kComponents);
    } else {
      search.continue_search(most, result);
    }
    if (most != kNoLimit) break;  // ending a search and starting the next one takes one call each
  }
  if (!std::is_sorted(result.relabelled.begin(),
                      result.relabelled.end()))  // halves of pairs are relabelled together
    std::sort(result.relabelled.begin(), result.relabelled.end());
  if (is_settled(body)) state.ties.clear();
  start_step(state);
  return result;
}

void join_parts(Body& body, FaceId a, FaceId b) {
  KERF_ASSERT(is_settled(body) && body.label(a) == body.label(b));
  LoadedComponents& components = body.components;
  constexpr uint32_t kCutOff = LoadedComponents::kNone;
  const uint32_t label = body.label(a);
  const uint32_t of_a = components.at_home(body.loaded_base(a), label);
  const uint32_t of_b = components.at_home(body.loaded_base(b), label);
  if (of_a == of_b) return;
  if (of_a != kCutOff && of_b != kCutOff) return components.join(of_a, of_b);
  const uint32_t component = of_a != kCutOff ? of_a : of_b;
  FaceCounts& cut_off = body.pieces.edit(label).cut_off;
  const FaceCounts counts = std::exchange(components.left.edit(component), {});
  cut_off.faces += counts.faces;
  cut_off.area += counts.area;
  components.home.edit(component) = kCutOff;
}

void search_from(Body& body, std::span<const FaceId> faces) {
  KERF_ASSERT(is_settled(body));
  KERF_ASSERT(std::ranges::all_of(faces, [&](FaceId f) { return body.mesh.is_live(f); }));
  SeparationState fresh;
  fresh.joints_requested = body.separation.joints_requested;
  fresh.ties = std::move(body.separation.ties);
  fresh.cavities_requested = body.solid;
  for (const FaceId f : faces) fresh.ties.emplace_back(f, f);
  fresh.search.restart_requested = true;
  body.separation = std::move(fresh);
}

bool is_settled(const Body& body) {
  const OpenSearch& search = body.separation.search;
  return search.stage == OpenSearch::Stage::kNone && !search.restart_requested;
}

void forget_removals(Body& body) { body.separation = SeparationState{}; }

uint32_t label_components(const Mesh& mesh, std::vector<uint32_t>& label) {
  label.assign(mesh.face_slots(), kNoIndex);
  uint32_t components = 0;
  std::vector<FaceId> queue, neighbours;
  for (uint32_t seed = 0; seed < mesh.face_slots(); ++seed) {
    if (!mesh.is_live(FaceId(seed)) || label[seed] != kNoIndex) continue;
    label[seed] = components;
    queue.assign(1, FaceId(seed));
    for (size_t i = 0; i < queue.size(); ++i) {
      neighbours.clear();
      mesh.append_nearest_neighbours(queue[i], neighbours);
      for (const FaceId n : neighbours) {
        if (label[n.index] != kNoIndex) continue;
        label[n.index] = components;
        queue.push_back(n);
      }
    }
    ++components;
  }
  return components;
}

}  // namespace kerf
