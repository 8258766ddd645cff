#include "core/document/commands/pin_piece.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"

namespace kerf {

std::string PinPiece::words() const { return (pinned ? "Pin " : "Unpin ") + piece_words(piece); }

void describe(Fields& f, PinPiece& c) {
  piece_field(f, c.piece);
  f.flag("pinned", c.pinned);
}

Result<Delta> PinPiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, [&](const Body& body) { return body.pinned != pinned; },
      [&](World& edited, BodyId own) {
        edited.body(own).pinned = pinned;
        edited.body(own).motion = {};
        Delta change;
        change.pinned = {own};
        return change;
      });
}

}  // namespace kerf
