#include "core/document/commands/advance.h"

namespace kerf {

std::string Advance::words() const { return bodies ? "Time with moving bodies" : "Time"; }

void Advance::write(CommandWriter& line) const {
  line.whole_number("ticks", ticks);
  if (bodies) line.flag("bodies", true);
  if (joins) line.flag("joins", true);
}

Result<Advance> Advance::read(const CommandReader& line) {
  const auto ticks = line.whole_number("ticks", 1, kMostInALine);
  if (!ticks) return ticks.error();
  Advance advance{*ticks};
  for (const auto& [key, set] : {std::pair("bodies", &advance.bodies), std::pair("joins", &advance.joins)}) {
    if (!line.has(key)) continue;
    const auto flag = line.flag(key);
    if (!flag) return flag.error();
    *set = *flag;
  }
  return advance;
}

}  // namespace kerf
