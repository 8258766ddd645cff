#include "core/document/commands/duplicate_piece.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"
#include "core/edit/detach.h"

namespace kerf {

std::string DuplicatePiece::words() const { return "Duplicate " + piece_words(piece); }

void describe(Fields& f, DuplicatePiece& c) {
  piece_field(f, c.piece);
  describe(f, c.to);
}

Result<Delta> DuplicatePiece::run(World& world, uint32_t generation, const Progress*) const {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  Delta delta;
  const BodyId copy = duplicate(world, piece, generation, delta);
  world.body(copy).placement = to;
  return delta;
}

}  // namespace kerf
