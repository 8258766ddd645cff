#include "core/document/commands/hide_piece.h"

#include "core/document/commands/edit_piece.h"

namespace kerf {

std::string HidePiece::words() const { return (hidden ? "Hide " : "Show ") + piece_words(piece); }

void HidePiece::write(CommandWriter& line) const {
  line.piece(piece);
  line.flag("hidden", hidden);
}

Result<HidePiece> HidePiece::read(const CommandReader& line) {
  const auto piece = line.piece();
  if (!piece) return piece.error();
  const auto hidden = line.flag("hidden");
  if (!hidden) return hidden.error();
  return HidePiece{*piece, *hidden};
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
