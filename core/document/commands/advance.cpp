#include "core/document/commands/advance.h"

namespace kerf {

std::string Advance::words() const { return "Time"; }

void Advance::write(CommandWriter& line) const { line.whole_number("ticks", ticks); }

Result<Advance> Advance::read(const CommandReader& line) {
  const auto ticks = line.whole_number("ticks", 1, kMostInALine);
  if (!ticks) return ticks.error();
  return Advance{*ticks};
}

}  // namespace kerf
