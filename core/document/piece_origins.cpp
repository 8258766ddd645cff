#include "core/document/piece_origins.h"

#include <map>

namespace kerf {

namespace {

// The id at the position of the history of a body that had the id `id` after a step.
BodyId id_at_position(const History& history, size_t step, BodyId id) {
  for (size_t i = step + 1; i < history.position(); ++i) id = history.step(i).id_after_step(id);
  return id;
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
    for (const auto& [cut_in, faces] : history.step(step).cut_faces()) {
      const BodyId id = id_at_position(history, step, cut_in);
      if (!world.contains(id)) continue;
      const Mesh& mesh = world.body(id).mesh;
      for (const CutFace& cut : faces) {
        for (const FaceId n : cut.neighbours) {
          if (!mesh.is_live(n)) continue;
          const uint32_t label = mesh.data(n).piece;
          if (label <= cut.piece) continue;
          origins[{id, label}] = {{id, label}, cut.piece, step};
        }
      }
    }
  }
  std::vector<PieceOrigin> all;
  for (const auto& [piece, origin] : origins) all.push_back(origin);
  return all;
}

}  // namespace kerf
