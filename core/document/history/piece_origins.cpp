#include "core/document/history/piece_origins.h"

#include <map>

namespace kerf {

namespace {

// The name at the position of the history of a piece that had the name `piece` after a step.
PieceId at_position(const History& history, size_t step, PieceId piece) {
  for (size_t i = step + 1; i < history.position(); ++i) piece = history.step(i).piece_after_step(piece);
  return piece;
}

}  // namespace

std::vector<PieceNode> piece_origins(const Document& document) {
  const History& history = document.history();
  std::vector<PieceNode> all = piece_nodes(document.world());
  std::map<PieceId, PieceNode*> nodes;
  for (PieceNode& node : all) nodes[node.piece] = &node;
  for (size_t step = 0; step < history.position(); ++step) {
    for (const auto& [piece, from] : history.step(step).came_off()) {
      const auto found = nodes.find(at_position(history, step, piece));
      if (found == nodes.end()) continue;
      found->second->came_off = at_position(history, step, {piece.body, from});
      found->second->step = step;
    }
  }
  return all;
}

}  // namespace kerf
