#include "core/edit/separation.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/base/assert.h"
#include "core/edit/part_search.h"

namespace kerf {

void CutLoops::remove(FaceId f) {
  assert(mesh_.is_live(f));
  const Edges edges = edges_of(f);
  state_.over_rings |= edges.others;
  state_.cannot_know |= edges.others && state_.neighbours.size() > 1;
  const auto c = mesh_.corners(f);
  for (const VertexId v : c) meet(v);
  const int joined = int{unite(c[0], c[1])} + int{unite(c[1], c[2])} + int{unite(c[2], c[0])};
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
  if (state.cannot_know || (state.over_rings && state.any_closed)) return true;
  // A face without neighbours was the last one of a component, or of a few faces that earlier removals had
  // enclosed; that loop is included in the sum.
  if (state.loops + state.alone <= 0) return false;
  return state.loops + vanished_components(mesh, state) > 0;
}

void start_step(SeparationState& state) {
  state.first_tie = state.ties.size();
  state.loops = state.alone = 0;
  state.any_closed = state.over_rings = state.cannot_know = false;
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
  bool& again = state.search.asked_again;
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
  SeparationState fresh;
  fresh.joints_requested = body.separation.joints_requested;
  fresh.ties = std::move(body.separation.ties);
  fresh.cavities_requested = true;
  for (const FaceId f : faces) fresh.ties.emplace_back(f, f);
  fresh.search.asked_again = true;
  body.separation = std::move(fresh);
}

bool is_settled(const Body& body) {
  const OpenSearch& search = body.separation.search;
  return search.stage == OpenSearch::Stage::kNone && !search.asked_again;
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
