#pragma once

#include "core/document/commands.h"
#include "ui/editor/pieces/piece_move.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/viewport.h"
#include "ui/window/number_fields.h"

namespace kerf {

// A handle of the selected piece, shown with the Select tool: an arrow along each world axis that moves the
// piece, and a ring about each that turns it. Landmarks: "move X", "turn Y".
struct PieceHandle : GizmoHandle {
  PieceMove::Kind kind = PieceMove::Kind::kMove;
  PieceMove::Axis axis = PieceMove::Axis::kX;
};

// Returns the pivot of the moved piece or, with the Select tool (`picks`), of the selected one. Returns
// nullopt unless exactly one piece is selected, or if the pivot lies behind the eye.
std::optional<Vec3> pivot_shown(const ViewState& view, const std::optional<PieceMove>& move, bool picks,
                                const World& world);

// Returns the handles around a pivot; none without one.
std::vector<PieceHandle> piece_handles(const ViewState& view, const std::optional<Vec3>& pivot);

// Draws the handles, with the one at `pointer` highlighted; during a move draws the locked axis and a
// description instead.
void draw_piece_handles(const ViewState& view, const std::optional<Vec3>& pivot,
                        const std::optional<PieceMove>& move, Vec2 pointer, ImDrawList& list);

// Converts to and from angles in degrees: the orientation turns about the world axes X, then Y, then Z. The
// angle about Y is in [-90, 90].
Vec3 angles_of(const glm::dquat& orientation);
glm::dquat orientation_of(const Vec3& angles);

// Fields for the placement of the selected piece: its centre of area in file units, and its angles about
// this centre.
class PlacementRows {
 public:
  // Unless exactly one piece is selected, the fields are empty, so that rows below keep their place. Returns
  // the command when a field is confirmed by Enter or left.
  std::optional<Command> draw(const World& world, const ViewState& view);

 private:
  std::optional<Command> draw_fields(const World& world, const ViewState& view, const PieceId& piece);
  void draw_empty(const char* why);

  NumberFields fields_;
};

}  // namespace kerf
