#include "core/document/commands/smooth_piece.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/commands/remake_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"

namespace kerf {

std::string SmoothPiece::words() const {
  return "Smooth " + piece_words(piece) + (times == 1 ? "" : ", " + std::to_string(times) + " times");
}

void describe(Fields& f, SmoothPiece& c) {
  piece_field(f, c.piece);
  f.whole("times", c.times, 1, kMostSmoothing);
}

Result<Delta> SmoothPiece::run(World& world, uint32_t generation, const Progress* progress) const {
  return remake_piece(
      world, piece, generation,
      [&](const Mesh& mesh, const HeededFaces& heeded, const Progress* working) {
        return smooth(mesh, times, heeded.kept, working);
      },
      progress);
}

}  // namespace kerf
