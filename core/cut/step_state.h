#pragma once

#include <vector>

#include "core/cut/cut_step.h"
#include "core/graph/separation.h"

namespace kerf {

// What the stages of a step hand to one another, for one body.
struct BodyStep {
  BodyStep(BodyId body_id, Body& cut_body) : id(body_id), body(cut_body) {}

  BodyId id;
  Body& body;
  std::vector<SweptCylinder> beam;  // of the current move, in the body's frame
  std::vector<FaceId> hit;          // faces that the beam touches, each once
  Separation separation;
  std::vector<FaceId> edited;  // slots that were born, reused or removed in this step, with repeats
  size_t removed_faces = 0;
  double removed_area = 0;
  StepFigures figures;
};

// The stages. Each does one thing to the state; cut_step puts them in order.
void sweep(BodyStep& step, const Laser& laser, const BeamMove& move);
void hit(BodyStep& step);
// Whether anything was split; fails at settings.most_faces and when `progress` stops it.
Result<bool> refine(BodyStep& step, const CutSettings& settings, const Progress& progress);
void remove(BodyStep& step);
BodyDelta separate(BodyStep& step);

}  // namespace kerf
