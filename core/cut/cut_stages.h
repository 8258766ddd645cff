#pragma once

#include <span>
#include <vector>

#include "core/cut/cut_step.h"
#include "core/edit/body_edit.h"

namespace kerf {

// The state that the stages of a step share, for one body.
struct BodyStep {
  BodyStep(BodyId body_id, Body& cut_body) : id(body_id), edit(cut_body) {}

  const Body& body() const { return edit.body(); }
  const Mesh& mesh() const { return edit.mesh(); }

  BodyId id;
  BodyEdit edit;
  std::vector<SweptCylinder> beam;  // volumes of the current move, in the body's frame
  StepStatistics statistics;
};

// The number of faces that are processed before the tree is updated, and the smallest amount of work of a
// step: 128 unless choices are varied (see Shuffle). What is cut does not depend on it.
size_t faces_together();

// The stages, which cut_step calls in order.
// Sets the volumes that the beam sweeps in a move, which is in world coordinates or in the frame of the body.
void sweep(BodyStep& step, const Laser& laser, const BeamMove& move, bool in_body_frame = false);
// Finds the faces that the beam touches, each once, ascending.
void hit(BodyStep& step, std::vector<FaceId>& faces);
// Processes the next faces_together() faces of move.to_split. Fails if settings.max_faces is exceeded or
// `progress` stops it.
Status refine(BodyStep& step, UnfinishedMove& move, const CutSettings& settings, const Progress& progress);
// Whether the resolution lets a face stay as it is under the beam of the move. Precondition: the face is
// live.
bool is_fine_enough(const BodyStep& step, const CutSettings& settings, FaceId f);
// Removes the next faces_together() faces of move.hit; with `only_within` only those that lie entirely within
// the beam of the move. With `keeps_beside` their neighbours are listed in move.beside.
void remove(BodyStep& step, UnfinishedMove& move, bool only_within, bool keeps_beside);
// Removes faces. If only one half of a green pair is removed, the other one becomes an ordinary face.
void remove_faces(BodyStep& step, std::span<const FaceId> faces);
// Splits a face and those that have to follow it; does nothing if the face is too small for midpoints.
// Returns the new entries of step.edit.splits().
std::span<const Replacement> split_by_scheme(BodyStep& step, Scheme scheme, FaceId f);
// Calls BodyEdit::update_tree and measures its time.
void update_tree(BodyStep& step);
// Searches for separated parts, visiting about `most` faces; see kerf::settle. Returns the number of faces
// visited and relabelled. `hit` are the faces of which some were removed since the last search.
size_t separate(World& world, BodyStep& step, std::span<const FaceId> hit, size_t most,
                EditPolicy policy = EditPolicy::kAllowEdits);
// Separates what joints do not hold any more (see hold_parts), and gives cavities to the pieces around them
// (see hold_cavities), once nothing is left to be searched.
void hold_what_joints_hold(World& world, Delta& delta, Hold hold = Hold::kStill);
// Ends the step of a body and adds its changes and statistics to the result.
void end_step(BodyStep& step, StepResult& result);
// Adds the changes alone. Returns them, valid until the result changes, or null if there are none.
const BodyDelta* take_changes(BodyStep& step, StepResult& result);
// The error of a cut that exceeds settings.max_faces.
Error too_many_faces(const CutSettings& settings);

// Leaves the heat of a cut by the geometric model in the faces beside what a move of the beam removed: where
// the body is d metres away from the volume that the beam swept, it is as hot as the transition of its
// material (melting) at d = 0 and less, linearly in d, down to the ambient at d = settings.heat_width. A face
// gets the mean of the enthalpy over its area, from samples finer than the width; no face is split for it. A
// face that is hotter keeps its heat, so that moves which overlap do not add up. The energy is booked as
// emitted and absorbed.
//
// Only faces that hang together with `beside` within that distance are heated: the live faces that the beam
// touched or that adjoin removed ones. Precondition: step.beam is that of the move, and heat_width > 0.
// O(faces within the width).
void deposit_heat(World& world, BodyStep& step, const CutSettings& settings, std::span<const FaceId> beside);

// Makes walls as hot as the transition of their material, since they lie where the beam was. Booked likewise.
void heat_walls(World& world, const BodyStep& step, std::span<const FaceId> walls);

}  // namespace kerf
