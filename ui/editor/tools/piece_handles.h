#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/editor/tools/hand.h"
#include "ui/editor/view/view_state.h"

struct ImDrawList;

namespace kerf {

// Handles around the chosen piece, in the first half of the picture, while the tool that picks is in hand: an
// arrow along each axis of the world that moves the piece, and a ring about each that turns it. They are as
// large at every distance. Places are of the window, screen coordinates.
struct PieceHandle {
  PieceMove::Kind kind = PieceMove::Kind::kMove;
  PieceMove::Axis axis = PieceMove::Axis::kX;
  std::vector<Vec2> line;  // from the pivot to the tip of an arrow, or the half of a ring that is in front
};

// The handles; none where not exactly one piece is chosen, or where it is behind the eye.
std::vector<PieceHandle> piece_handles(const ViewState& view, const Hand& hand, const World& world);

// The handle at a place, if any.
std::optional<PieceHandle> handle_under(const std::vector<PieceHandle>& handles, Vec2 at);

// The name of a handle, as tests know it: "move X", "turn Y".
std::string name_of(const PieceHandle& handle);
// The place of a handle that its name stands for.
Vec2 grip_of(const PieceHandle& handle);

// Draws the handles, or, during a move, the axis that it is constrained to, and what it does in words.
void draw_piece_handles(const ViewState& view, const Hand& hand, const World& world, ImDrawList& list);

}  // namespace kerf
