#pragma once

#include <span>
#include <vector>

#include "core/cut/cut_step.h"
#include "core/graph/body_edit.h"

namespace kerf {

// What the stages of a step hand to one another, for one body.
struct BodyStep {
  BodyStep(BodyId body_id, Body& cut_body) : id(body_id), edit(cut_body) {}

  const Body& body() const { return edit.body(); }
  const Mesh& mesh() const { return edit.mesh(); }

  BodyId id;
  BodyEdit edit;
  std::vector<SweptCylinder> beam;  // of the current move, in the body's frame
  StepFigures figures;
};

// So many faces are looked at before the tree follows what was split or removed: the least that a step does.
// The boxes of the tree depend on it, and by the order of what it finds all that is cut.
inline constexpr size_t kFacesTogether = 128;

// The stages. Each does one thing to the state; cut_step puts them in order.
void sweep(BodyStep& step, const Laser& laser, const BeamMove& move);
// Finds the faces that the beam touches, each once.
void hit(BodyStep& step, std::vector<FaceId>& faces);
// Looks at the next kFacesTogether of move.to_split; fails at settings.most_faces and when `progress` stops
// it.
Status refine(BodyStep& step, UnfinishedMove& move, const CutSettings& settings, const Progress& progress);
// Removes the next kFacesTogether that were hit, or of them only what lies wholly within the beam of the
// move.
void remove(BodyStep& step, UnfinishedMove& move, bool only_within);
// These; both halves of a green pair or a half that is alone from now on.
void remove_faces(BodyStep& step, std::span<const FaceId> faces);
// Splits a face and what must follow it; nothing where coordinates have no midpoints. The new entries of
// step.edit.splits().
std::span<const Replacement> split_by_scheme(BodyStep& step, Scheme scheme, FaceId f);
// BodyEdit::update_tree, with its time taken.
void update_tree(BodyStep& step);
// Looks at so many faces or few more for what came apart; see kerf::settle. How many they were, those with a
// new label among them.
size_t separate(BodyStep& step, size_t most);
// Ends the step of a body: adds what it did to the result.
void end_step(BodyStep& step, StepResult& result);
// The error of a cut that goes beyond settings.most_faces.
Error too_many_faces(const CutSettings& settings);

}  // namespace kerf
