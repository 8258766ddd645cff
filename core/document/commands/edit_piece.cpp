#include "core/document/commands/edit_piece.h"

#include "core/edit/detach.h"

namespace kerf {

std::string piece_words(const PieceId& piece) {
  const std::string body = "body " + std::to_string(piece.body.slot + 1);
  return piece.label == 0 ? body : "piece " + std::to_string(piece.label) + " of " + body;
}

bool has_faces(const World& world, const PieceId& piece) {
  if (!world.contains(piece.body)) return false;
  const auto& pieces = world.body(piece.body).pieces;
  return piece.label < pieces.size() && pieces[piece.label].faces > 0;
}

Error no_such_piece(const PieceId& piece) {
  return bad_input("there is no piece " + std::to_string(piece.label) + " of body " +
                   std::to_string(piece.body.slot));
}

Result<Delta> edit_piece(World& world, const PieceId& piece, uint32_t generation,
                         std::vector<BodyId> Delta::*told, const std::function<bool(const Body&)>& differs,
                         const std::function<void(Body&)>& edit) {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  Delta delta, change;
  if (!differs(world.body(piece.body))) return delta;
  const BodyId own = detach(world, piece, generation, delta);
  edit(world.body(own));
  change.*told = {own};
  delta.append(std::move(change));
  return delta;
}

}  // namespace kerf
