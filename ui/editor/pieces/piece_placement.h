#pragma once

#include "core/document/commands.h"
#include "ui/editor/pieces/piece_move.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/viewport.h"
#include "ui/window/number_fields.h"

namespace kerf {

// Handles around the chosen piece while the tool that picks is in hand: an arrow along each axis of the world
// that moves the piece, and a ring about each that turns it. Their names: "move X", "turn Y".
struct PieceHandle : GizmoHandle {
  PieceMove::Kind kind = PieceMove::Kind::kMove;
  PieceMove::Axis axis = PieceMove::Axis::kX;
};

// The point of the picture about which the piece turns that is moved or, with the tool that picks, is chosen.
// Nothing where not exactly one piece is chosen, or where the point is behind the eye.
std::optional<Vec3> pivot_shown(const ViewState& view, const std::optional<PieceMove>& move, bool picks,
                                const World& world);

// The handles around a pivot; none without one.
std::vector<PieceHandle> piece_handles(const ViewState& view, const std::optional<Vec3>& pivot);

// Draws the handles, the one at `pointer` highlighted, or, during a move, the axis that it is constrained to,
// and what it does in words.
void draw_piece_handles(const ViewState& view, const std::optional<Vec3>& pivot,
                        const std::optional<PieceMove>& move, Vec2 pointer, ImDrawList& list);

// Angles in degrees about the axes of the world: the orientation turns about X first, then about Y, then
// about Z. The angle about Y is within 90 degrees of 0.
Vec3 angles_of(const glm::dquat& orientation);
glm::dquat orientation_of(const Vec3& angles);

// Where the chosen piece stands as numbers that can be typed: its centre of area in the unit of the file, and
// its angles, which turn it about this centre.
class PlacementRows {
 public:
  // Where not exactly one piece is chosen the fields are empty, so that what is below stays in its place when
  // one is. Enter or leaving a field returns the command.
  std::optional<Command> draw(const World& world, const ViewState& view);

 private:
  std::optional<Command> draw_fields(const World& world, const ViewState& view, const PieceId& piece);
  void draw_empty(const char* why);

  NumberFields fields_;
};

}  // namespace kerf
