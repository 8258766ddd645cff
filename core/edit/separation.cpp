#include "core/edit/separation.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/edit/cut_loops.h"
#include "core/edit/part_search.h"
#include "core/edit/tie_clusters.h"

namespace kerf {

namespace {

// The number of components that were removed entirely: clusters of removed faces without a live face.
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

bool may_have_come_apart(const Mesh& mesh, SeparationState& state) {
  if (state.cannot_know || (state.over_rings && state.any_closed)) return true;
  // A face without neighbours was the last one of a component, or of a few faces that the removals had
  // enclosed before; that loop is included in the sum.
  if (state.loops + state.alone <= 0) return false;
  return state.loops + vanished_components(mesh, state) > 0;
}

void start_step(SeparationState& state) {
  state.first_tie = state.ties.size();
  state.loops = state.alone = 0;
  state.any_closed = state.over_rings = state.cannot_know = false;
}

}  // namespace

void note_removal(Body& body, FaceId f) {
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
  if (!is_settled(body)) PartSearch(body).note_removal(f);
}

void note_replaced(Body& body, const Replacement& replaced) {
  if (!is_settled(body)) PartSearch(body).note_replaced(replaced);
}

void note_turned(Body& body, FaceId f, double area_gained) {
  KERF_ASSERT(body.mesh.is_live(f));
  if (!is_settled(body)) PartSearch(body).note_turned(f, area_gained);
}

SettleResult settle(Body& body, size_t most, Meanwhile meanwhile) {
  SeparationState& state = body.separation;
  SettleResult result;
  PartSearch search(body, meanwhile);
  bool& again = state.search.asked_again;
  if (may_have_come_apart(body.mesh, state)) {
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
      search.go_on(most, result);
    }
    if (most != kNoLimit) break;  // the end of a search and the start of the next one are a call each
  }
  if (!std::is_sorted(result.relabelled.begin(), result.relabelled.end()))  // halves of pairs go together
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
  fresh.joints_asked = body.separation.joints_asked;
  fresh.ties = std::move(body.separation.ties);
  fresh.cavities_asked = true;
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
