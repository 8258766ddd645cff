#include "core/document/commands/stop_stroke.h"

#include "core/document/text/fields.h"

namespace kerf {

namespace {
constexpr double kMostMoves = 1e9;
constexpr Ticks kMostTicks = Ticks{1} << 40;
}  // namespace

void describe(Fields& f, StopStroke& c) {
  f.number("moves", c.moves, {0, kMostMoves});
  f.whole("ticks", c.ticks, 0, kMostTicks, 0);
}

}  // namespace kerf
