#include "core/document/commands/time_commands.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/world_fields.h"

namespace kerf {

void describe(Fields& f, Advance& c) {
  f.whole("ticks", c.ticks, 1, Advance::kMostInALine);
  f.flag("bodies", c.bodies, false);
  f.flag("joins", c.joins, false);
}

std::string Pull::words(const std::string& piece_name) const { return "Pull " + piece_name; }

void describe(Fields& f, Pull& c) {
  piece_field(f, c.piece);
  f.vector("at", c.at);
  f.vector("to", c.to);
}

}  // namespace kerf
