#include "core/document/commands/rename_piece.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"

namespace kerf {

std::string RenamePiece::words() const { return "Name " + piece_words(piece) + " " + name; }

void describe(Fields& f, RenamePiece& c) {
  piece_field(f, c.piece);
  f.text("name", c.name);
}

Result<Delta> RenamePiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, [&](const Body& body) { return body.name_of(piece.label) != name; },
      [&](World& edited, BodyId own) {
        edited.body(own).name = name;
        edited.body(own).named = piece.label;
        Delta change;
        change.renamed = {own};
        return change;
      });
}

}  // namespace kerf
