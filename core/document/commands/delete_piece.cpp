#include "core/document/commands/delete_piece.h"

#include "core/document/commands/edit_piece.h"

namespace kerf {

std::string DeletePiece::words() const { return "Delete " + piece_words(piece); }

void DeletePiece::write(CommandWriter& line) const { line.piece(piece); }

Result<DeletePiece> DeletePiece::read(const CommandReader& line) {
  const auto piece = line.piece();
  if (!piece) return piece.error();
  return DeletePiece{*piece};
}

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
