#include "core/document/commands/time_commands.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/world_fields.h"

namespace kerf {

void describe(Fields& f, AdvanceTime& c) {
  f.whole("ticks", c.ticks, 1, AdvanceTime::kMostInALine);
  f.flag("bodies", c.bodies, false);
  f.flag("joins", c.joins, false);
}

std::string DragBody::words(const std::string& piece_name) const { return "Pull " + piece_name; }

void describe(Fields& f, DragBody& c) {
  piece_field(f, c.piece);
  f.vector("at", c.at);
  f.vector("to", c.to);
}

}  // namespace kerf
