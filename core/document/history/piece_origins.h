#pragma once

#include <vector>

#include "core/document/history/document.h"
#include "core/graph/piece_node.h"

namespace kerf {

// The graph of pieces: those that have faces, ascending by piece, with what they came off and what holds
// them. O(p log p) in the pieces of the world and those that came off in the history, for each step that
// follows.
std::vector<PieceNode> piece_origins(const Document& document);

}  // namespace kerf
