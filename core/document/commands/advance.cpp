#include "core/document/commands/advance.h"

#include "core/document/text/fields.h"

namespace kerf {

std::string Advance::words() const { return bodies ? "Time with moving bodies" : "Time"; }

void describe(Fields& f, Advance& c) {
  f.whole("ticks", c.ticks, 1, Advance::kMostInALine);
  f.flag("bodies", c.bodies, false);
  f.flag("joins", c.joins, false);
}

}  // namespace kerf
