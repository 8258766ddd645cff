#pragma once

#include "ui/editor/moving/piece_move.h"
#include "ui/editor/shared/picture/gizmo.h"

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

}  // namespace kerf
