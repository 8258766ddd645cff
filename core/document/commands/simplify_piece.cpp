#include "core/document/commands/simplify_piece.h"

#include <cmath>

#include "core/document/commands/edit_piece.h"
#include "core/document/commands/remake_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"

namespace kerf {

std::string SimplifyPiece::words() const { return "Simplify " + piece_words(piece); }

void describe(Fields& f, SimplifyPiece& c) {
  piece_field(f, c.piece);
  if (f.present("error", std::isfinite(c.target.error))) {
    f.number("error", c.target.error, kPositive);
    f.present("faces", false);
  } else {
    f.whole("faces", c.target.faces, 1, FaceId::kNone);
  }
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
