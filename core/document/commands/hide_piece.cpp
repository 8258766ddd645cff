#include "core/document/commands/hide_piece.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"

namespace kerf {

std::string HidePiece::words() const { return (hidden ? "Hide " : "Show ") + piece_words(piece); }

void describe(Fields& f, HidePiece& c) {
  piece_field(f, c.piece);
  f.flag("hidden", c.hidden);
}

Result<Delta> HidePiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, [&](const Body& body) { return body.hidden != hidden; },
      [&](World& edited, BodyId own) {
        edited.body(own).hidden = hidden;
        Delta change;
        change.hid_or_showed = {own};
        return change;
      });
}

}  // namespace kerf
