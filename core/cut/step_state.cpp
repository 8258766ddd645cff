#include "core/cut/step_state.h"

#include <algorithm>
#include <iterator>

#include "core/base/shuffle.h"
#include "core/cut/stopwatch.h"

namespace kerf {

namespace {

bool within_beam(const BodyStep& step, FaceId f) {
  const Triangle element = step.body().refinement.triangle(step.mesh(), f);
  return std::any_of(step.beam.begin(), step.beam.end(),
                     [&](const SweptCylinder& part) { return part.contains(element); });
}

}  // namespace

size_t faces_together() {
  static const size_t faces = [] {
    constexpr size_t kVaried[] = {1, 17, 128, 3000};
    const Shuffle& shuffle = Shuffle::chosen();
    return shuffle.on() ? kVaried[shuffle.random(2).below(std::size(kVaried))] : 128;
  }();
  return faces;
}

void sweep(BodyStep& step, const Laser& laser, const BeamMove& move, bool in_body_frame) {
  const Placement& placement = step.body().placement;
  const BeamMove seen{placement.to_body(move.from), placement.to_body(move.to)};
  step.beam = sweep_beam(laser, in_body_frame ? move : seen);
}

void hit(BodyStep& step, std::vector<FaceId>& faces) {
  const Stopwatch watch(step.statistics.query_s);
  faces.clear();
  for (const SweptCylinder& part : step.beam) {
    const QueryCounts counts = step.edit.touched(part, faces);
    ++step.statistics.queries;
    step.statistics.tested.boxes += counts.boxes;
    step.statistics.tested.faces += counts.faces;
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

// A green pair goes as a whole: when the beam touches either half, or holds both where the rim is to be
// smooth.
void remove(BodyStep& step, UnfinishedMove& move, bool only_within, bool keeps_beside) {
  std::vector<FaceId> going;
  const size_t end = std::min(move.hit.size(), move.removed + faces_together());
  for (; move.removed < end; ++move.removed) {
    const FaceId f = move.hit[move.removed];
    if (!step.mesh().is_live(f)) continue;  // went with the other half of its pair
    if (only_within && !within_beam(step, f)) continue;
    const OneToFour::Element element = step.body().refinement.element(step.mesh(), f);
    going.insert(going.end(), element.faces.begin(), element.faces.begin() + element.face_count);
  }
  if (keeps_beside) {
    for (const FaceId f : going) step.mesh().append_neighbours(f, move.beside);
  }
  remove_faces(step, going);
}

void remove_faces(BodyStep& step, std::span<const FaceId> faces) {
  {
    const Stopwatch watch(step.statistics.remove_s);
    step.edit.remove(faces);
  }
  update_tree(step);
}

}  // namespace kerf
