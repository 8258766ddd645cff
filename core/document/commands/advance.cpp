#include "core/document/commands/advance.h"

namespace kerf {

std::string Advance::words() const { return bodies ? "Time with moving bodies" : "Time"; }

void Advance::write(CommandWriter& line) const {
  line.whole_number("ticks", ticks);
  if (bodies) line.flag("bodies", true);
}

Result<Advance> Advance::read(const CommandReader& line) {
  const auto ticks = line.whole_number("ticks", 1, kMostInALine);
  if (!ticks) return ticks.error();
  Advance advance{*ticks};
  if (line.has("bodies")) {
    const auto bodies = line.flag("bodies");
    if (!bodies) return bodies.error();
    advance.bodies = *bodies;
  }
  return advance;
}

}  // namespace kerf
