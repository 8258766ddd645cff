#pragma once

#include <string>
#include <vector>

#include "core/document/history/piece_origins.h"
#include "ui/editor/shared/picture/view_state.h"

namespace kerf {

// A row of the tree of pieces.
struct PieceTreeRow {
  PieceNode origin;
  int depth = 0;  // 0 for what is left of a body
};

// The pieces as a tree: under each piece those that came off it, in the order of their steps.
std::vector<PieceTreeRow> piece_tree(const std::vector<PieceNode>& origins);

// What a piece came off, what holds it, and what stands with it, in sentences. Precondition: its body exists.
std::string words_on(const PieceNode& node, const Document& document, FileUnit unit);

// Draws them: what came off what, in which step of the history, what holds it, and how many faces are left of
// it. A click chooses a piece, on which there are a few words then.
void draw_piece_tree(const std::vector<PieceTreeRow>& rows, const Document& document, ViewState& view);

}  // namespace kerf
