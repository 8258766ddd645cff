#include "core/document/commands/pull.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"

namespace kerf {

std::string Pull::words() const { return "Pull " + piece_words(piece); }

void describe(Fields& f, Pull& c) {
  piece_field(f, c.piece);
  f.vector("at", c.at);
  f.vector("to", c.to);
}

}  // namespace kerf
