#include "core/document/commands/simplify_piece.h"

#include <cmath>

#include "core/document/commands/edit_piece.h"
#include "core/document/commands/remake_piece.h"

namespace kerf {

std::string SimplifyPiece::words() const { return "Simplify " + piece_words(piece); }

void SimplifyPiece::write(CommandWriter& line) const {
  line.piece(piece);
  if (std::isfinite(target.error)) {
    line.number("error", target.error);
  } else {
    line.whole_number("faces", target.faces);
  }
}

Result<SimplifyPiece> SimplifyPiece::read(const CommandReader& line) {
  const auto piece = line.piece();
  if (!piece) return piece.error();
  SimplifyPiece command{*piece, {}};
  if (line.has("error")) {
    const auto error = line.positive_number("error");
    if (!error) return error.error();
    command.target.error = *error;
    return command;
  }
  const auto faces = line.whole_number("faces", 1, FaceId::kNone);
  if (!faces) return faces.error();
  command.target.faces = *faces;
  return command;
}

Result<Delta> SimplifyPiece::run(World& world, uint32_t generation, const Progress* progress) const {
  return remake_piece(
      world, piece, generation,
      [&](const Mesh& mesh, const HeededFaces& heeded, const Progress* working) {
        return simplify(mesh, target, heeded.kept, working, heeded.warm);
      },
      progress);
}

}  // namespace kerf
