#include "core/document/commands/pin_piece.h"

#include "core/document/commands/edit_piece.h"

namespace kerf {

std::string PinPiece::words() const { return (pinned ? "Pin " : "Unpin ") + piece_words(piece); }

void PinPiece::write(CommandWriter& line) const {
  line.piece(piece);
  line.flag("pinned", pinned);
}

Result<PinPiece> PinPiece::read(const CommandReader& line) {
  const auto piece = line.piece();
  if (!piece) return piece.error();
  const auto pinned = line.flag("pinned");
  if (!pinned) return pinned.error();
  return PinPiece{*piece, *pinned};
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
