#include "core/document/commands/delete_piece.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"

namespace kerf {

std::string DeletePiece::words() const { return "Delete " + piece_words(piece); }

void describe(Fields& f, DeletePiece& c) { piece_field(f, c.piece); }

Result<Delta> DeletePiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, [](const Body&) { return true; },
      [&](World& edited, BodyId own) {
        edited.remove(own);
        Delta change;
        change.went = {own};
        return change;
      });
}

}  // namespace kerf
