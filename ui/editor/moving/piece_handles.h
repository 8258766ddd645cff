#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/editor/moving/piece_move.h"
#include "ui/editor/shared/view_state.h"

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

// The picture with the point in it about which the piece turns.
struct HandleStage {
  CameraView camera;
  Area area;
  Vec3 pivot;
  double em;  // m of the world at the depth of the pivot that are as long as the text is high

  Vec2 place_of(const Vec3& p) const;
};

// That of the piece that is moved or, with the tool that picks, of the chosen one. Nothing where not exactly
// one piece is chosen, or where it is behind the eye.
std::optional<HandleStage> handle_stage(const ViewState& view, const std::optional<PieceMove>& move,
                                        bool picks, const World& world);

std::vector<PieceHandle> piece_handles(const std::optional<HandleStage>& stage);

// The handle at a place, if any.
std::optional<PieceHandle> handle_under(const std::vector<PieceHandle>& handles, Vec2 at);

// The name of a handle, as tests know it: "move X", "turn Y".
std::string name_of(const PieceHandle& handle);
// The place of a handle that its name stands for.
Vec2 grip_of(const PieceHandle& handle);

// Draws the handles, the one at `pointer` highlighted, or, during a move, the axis that it is constrained to,
// and what it does in words.
void draw_piece_handles(const ViewState& view, const std::optional<HandleStage>& stage,
                        const std::optional<PieceMove>& move, Vec2 pointer, ImDrawList& list);

}  // namespace kerf
