#include "core/document/commands/rename_piece.h"

#include "core/document/commands/edit_piece.h"

namespace kerf {

std::string RenamePiece::words() const { return "Name " + piece_words(piece) + " " + name; }

void RenamePiece::write(CommandWriter& line) const {
  line.piece(piece);
  line.text("name", name);
}

Result<RenamePiece> RenamePiece::read(const CommandReader& line) {
  const auto piece = line.piece();
  if (!piece) return piece.error();
  const auto name = line.text("name");
  if (!name) return name.error();
  return RenamePiece{*piece, *name};
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
