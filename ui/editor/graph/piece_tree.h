#pragma once

#include <vector>

#include "core/document/piece_origins.h"
#include "ui/editor/view/view_state.h"

namespace kerf {

// A row of the tree of pieces.
struct PieceTreeRow {
  PieceOrigin origin;
  int depth = 0;  // 0 for what is left of a body
};

// The pieces as a tree: under each piece those that came off it, in the order of their steps.
std::vector<PieceTreeRow> piece_tree(const std::vector<PieceOrigin>& origins);

// Draws them: what came off what, in which step of the history, and how many faces are left of it. A click
// chooses a piece.
void draw_piece_tree(const std::vector<PieceTreeRow>& rows, const Document& document, ViewState& view);

}  // namespace kerf
