#include "core/document/commands/subdivide_piece.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/commands/remake_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"

namespace kerf {

std::string SubdividePiece::words() const { return "Subdivide " + piece_words(piece); }

void describe(Fields& f, SubdividePiece& c) {
  piece_field(f, c.piece);
  f.choice("scheme", c.scheme, kSubdivisionNames);
}

Result<Delta> SubdividePiece::run(World& world, uint32_t generation, const Progress* progress) const {
  if (has_faces(world, piece) && world.body(piece.body).pieces[piece.label].faces > kMostToSubdivide)
    return bad_input(piece_words(piece) + " has too many faces to be subdivided");
  return remake_piece(
      world, piece, generation,
      [&](const Mesh& mesh, const HeededFaces& heeded, const Progress* working) {
        return subdivide(mesh, scheme, heeded.kept, working);
      },
      progress);
}

}  // namespace kerf
