#include "core/document/commands/move_piece.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"

namespace kerf {

std::string MovePiece::words() const { return "Move " + piece_words(piece); }

void describe(Fields& f, MovePiece& c) {
  piece_field(f, c.piece);
  describe(f, c.to);
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
