#include "core/document/commands/stop_stroke.h"

namespace kerf {

namespace {
constexpr double kMostMoves = 1e9;
constexpr Ticks kMostTicks = Ticks{1} << 40;
}  // namespace

void StopStroke::write(CommandWriter& line) const {
  line.number("moves", moves);
  if (ticks > 0) line.whole_number("ticks", ticks);
}

Result<StopStroke> StopStroke::read(const CommandReader& line) {
  const auto moves = line.number_within("moves", 0, kMostMoves);
  if (!moves) return moves.error();
  StopStroke stop{*moves};
  if (line.has("ticks")) {
    const auto ticks = line.whole_number("ticks", 0, kMostTicks);
    if (!ticks) return ticks.error();
    stop.ticks = *ticks;
  }
  return stop;
}

}  // namespace kerf
