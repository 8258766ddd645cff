#include "core/document/piece_origins.h"

#include <map>

namespace kerf {

namespace {

// The name at the position of the history of a piece that had the name `piece` after a step.
PieceId at_position(const History& history, size_t step, PieceId piece) {
  for (size_t i = step + 1; i < history.position(); ++i) piece = history.step(i).piece_after_step(piece);
  return piece;
}

}  // namespace

std::vector<PieceOrigin> piece_origins(const Document& document) {
  const World& world = document.world();
  const History& history = document.history();
  std::map<PieceId, PieceOrigin> origins;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      if (body.pieces[label].faces > 0) origins[{id, label}] = {{id, label}, std::nullopt, 0};
    }
  }
  for (size_t step = 0; step < history.position(); ++step) {
    for (const auto& [piece, from] : history.step(step).came_off()) {
      const auto found = origins.find(at_position(history, step, piece));
      if (found == origins.end()) continue;
      found->second.came_off = at_position(history, step, {piece.body, from});
      found->second.step = step;
    }
  }
  std::vector<PieceOrigin> all;
  for (const auto& [piece, origin] : origins) all.push_back(origin);
  return all;
}

}  // namespace kerf
