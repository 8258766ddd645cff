#include "core/document/commands/set_sheet.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"
#include "core/document/text/sheet_fields.h"

namespace kerf {

std::string SetSheet::words() const { return "Material of " + piece_words(piece); }

void describe(Fields& f, SetSheet& c) {
  piece_field(f, c.piece);
  describe(f, c.sheet);
}

Result<Delta> SetSheet::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, [&](const Body& body) { return body.sheet != sheet; },
      [&](World& edited, BodyId own) {
        edited.body(own).sheet = sheet;
        Delta change;
        change.reweighed = {own};
        return change;
      });
}

}  // namespace kerf
