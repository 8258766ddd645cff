#include "core/document/commands/duplicate_piece.h"

#include "core/document/commands/edit_piece.h"
#include "core/graph/detach.h"

namespace kerf {

std::string DuplicatePiece::words() const { return "Duplicate " + piece_words(piece); }

void DuplicatePiece::write(CommandWriter& line) const {
  line.piece(piece);
  line.placement(to);
}

Result<DuplicatePiece> DuplicatePiece::read(const CommandReader& line) {
  const auto piece = line.piece();
  if (!piece) return piece.error();
  const auto to = line.placement();
  if (!to) return to.error();
  return DuplicatePiece{*piece, *to};
}

Result<Delta> DuplicatePiece::run(World& world, uint32_t generation, const Progress*) const {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  Delta delta;
  const BodyId copy = duplicate(world, piece, generation, delta);
  world.body(copy).placement = to;
  return delta;
}

}  // namespace kerf
