#pragma once

#include <span>
#include <vector>

#include "core/cut/cut_step.h"
#include "core/edit/body_edit.h"

namespace kerf {

// State shared by the stages of a step, for one body.
struct BodyStep {
  BodyStep(BodyId body_id, Body& cut_body) : id(body_id), edit(cut_body) {}

  const Body& body() const { return edit.body(); }
  const Mesh& mesh() const { return edit.mesh(); }

  BodyId id;
  BodyEdit edit;
  std::vector<SweptCylinder> beam;  // volumes of the current move, in the body's frame
  StepStatistics statistics;
};

// Returns the number of faces processed between two updates of the tree, which is also the minimum work of a
// step: 128 unless Shuffle varies it. The result of a cut does not depend on it.
size_t faces_per_batch();

// The stages, in the order in which cut_step calls them.
// Sets the volumes that the beam sweeps in a move given in world coordinates or in the frame of the body.
void sweep(BodyStep& step, const Laser& laser, const BeamMove& move, bool in_body_frame = false);
// Finds the faces that the beam touches, each once, ascending.
void hit(BodyStep& step, std::vector<FaceId>& faces);
// Examines the next faces of move.to_split, until faces_per_batch() are examined or made. Fails at
// settings.max_faces or on cancellation.
Status refine(BodyStep& step, UnfinishedMove& move, const CutSettings& settings, const Progress& progress);
// Returns true if a face need not be split under the beam of the move. Precondition: the face is live.
bool is_fine_enough(const BodyStep& step, const CutSettings& settings, FaceId f);
// Removes the next faces_per_batch() faces of move.hit; with `only_within`, only faces entirely within the
// beam of the move. With `keeps_beside`, also records the neighbours of removed faces in the move.
void remove(BodyStep& step, UnfinishedMove& move, bool only_within, bool keeps_beside);
// Removes faces. If only one half of a green pair is removed, the other becomes an ordinary face.
void remove_faces(BodyStep& step, std::span<const FaceId> faces);
// Splits a face, and other faces as conformity requires. No-op if the face is so small that a midpoint would
// round to an end of its edge. Returns the new entries of step.edit.splits().
std::span<const Replacement> split_by_scheme(BodyStep& step, Scheme scheme, FaceId f);
// Calls BodyEdit::update_tree and adds its duration to the statistics.
void update_tree(BodyStep& step);
// Searches for separated parts, visiting about `most` faces; see kerf::settle. Returns the number of faces
// visited and relabelled. `hit`: faces, some of them removed since the last search.
size_t separate(World& world, BodyStep& step, std::span<const FaceId> hit, size_t most,
                EditPolicy policy = EditPolicy::kAllowEdits);
// Assigns cavities to the pieces around them, in every body without an unfinished search for separated pieces
// (see assign_cavities). Once no body has one, separates the parts that joints no longer hold (see
// separate_by_joints).
void apply_joints(World& world, Delta& delta, JointMode mode = JointMode::kRigid);
// Ends the step of a body and adds its changes and statistics to the result.
void end_step(BodyStep& step, StepResult& result);
// Adds only the changes of the step to the result. Returns them, valid until the result changes; null if
// there are none.
const BodyDelta* take_changes(BodyStep& step, StepResult& result);
// Returns the error of a cut that exceeds settings.max_faces.
Error too_many_faces(const CutSettings& settings);

// Deposits heat of a cut by the geometric model in the faces around the removed ones. At distance d (m) from
// the volume that the beam swept, the temperature falls linearly from the transition of the material
// (melting) at d = 0 to the ambient at d = settings.heat_width. A face gets the mean of the enthalpy over its
// area, from samples finer than the width; no face is split for it. A hotter face keeps its heat, so
// overlapping moves do not add up. Adds the energy to the world's energy balance as emitted and absorbed.
//
// Heats only faces that are connected to the given ones by faces within that distance. The given faces are
// live faces that the beam touched, or that are adjacent to removed faces. Preconditions: step.beam is that
// of the move, and heat_width > 0. O(faces within the width).
void deposit_heat(World& world, BodyStep& step, const CutSettings& settings, std::span<const FaceId> beside);

// Heats walls, which lie on the boundary of the beam, to the transition of their material. Adds the energy to
// the balance likewise.
void heat_walls(World& world, const BodyStep& step, std::span<const FaceId> walls);

}  // namespace kerf
