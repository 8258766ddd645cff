#include "core/document/commands/move_piece.h"

#include "core/document/commands/edit_piece.h"

namespace kerf {

std::string MovePiece::words() const { return "Move " + piece_words(piece); }

void MovePiece::write(CommandWriter& line) const {
  line.piece(piece);
  line.placement(to);
}

Result<MovePiece> MovePiece::read(const CommandReader& line) {
  const auto piece = line.piece();
  if (!piece) return piece.error();
  const auto to = line.placement();
  if (!to) return to.error();
  return MovePiece{*piece, *to};
}

Result<Delta> MovePiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, [&](const Body& body) { return body.placement != to; },
      [&](World& edited, BodyId own) {
        edited.body(own).placement = to;
        edited.body(own).motion = {};
        Delta change;
        change.moved = {own};
        return change;
      });
}

}  // namespace kerf
