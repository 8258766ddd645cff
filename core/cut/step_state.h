#pragma once

#include <span>
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
  std::vector<FaceId> edited;       // slots that were born, reused or removed in this step, with repeats
  std::vector<FaceId> relabelled;
  std::vector<uint32_t> new_pieces;
  size_t removed_faces = 0;
  double removed_area = 0;
  StepFigures figures;
};

// The stages. Each does one thing to the state; cut_step puts them in order.
void sweep(BodyStep& step, const Laser& laser, const BeamMove& move);
void hit(BodyStep& step);
// Whether anything was split; fails at settings.most_faces and when `progress` stops it.
Result<bool> refine(BodyStep& step, const CutSettings& settings, const Progress& progress);
// What was hit, or only what lies wholly within the beam of the move.
void remove(BodyStep& step, bool only_within);
// These; both halves of a green pair or a half that is alone from now on.
void remove_faces(BodyStep& step, std::span<const FaceId> faces);
// Splits a face and what must follow it; nothing where coordinates end.
void split_by_scheme(BodyStep& step, Scheme scheme, FaceId f, std::vector<Replacement>& out);
// Tells the tree, the counts and the delta what became of faces that were split.
void follow_splits(BodyStep& step, std::span<const Replacement> replaced);
// Looks at so many faces or few more for what came apart; see kerf::settle.
void separate(BodyStep& step, size_t most);
// Ends the step of a body: adds what it did to the result.
void end_step(BodyStep& step, StepResult& result);
// The error of a cut that goes beyond settings.most_faces.
Error too_many_faces(const CutSettings& settings);

}  // namespace kerf
