#include "core/document/commands/stroke_commands.h"

#include "core/base/length_text.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"
#include "core/document/text/settings_fields.h"

namespace kerf {

namespace {

constexpr double kMostMoves = 1e9;
constexpr Ticks kMostTicks = Ticks{1} << 40;

std::string fineness(const Resolution& r) {
  switch (r.rule) {
    case Resolution::Rule::kTargetEdge:
      return "edges of " + length_text(r.target_edge);
    case Resolution::Rule::kTolerance:
      return "within " + length_text(r.tolerance);
    case Resolution::Rule::kDepth:
      return std::to_string(r.depth) + (r.depth == 1 ? " level" : " levels");
  }
  return "";
}

}  // namespace

std::string BeginStroke::words() const {
  return "Stroke, radius " + length_text(settings.laser.radius) +
         (settings.laser.pattern == Pattern::kRays4 ? ", four rays" : "");
}

void describe(Fields& f, BeginStroke& c) {
  f.object("settings", c.settings);
  describe(f, c.pose);
}

void describe(Fields& f, MoveStroke& c) {
  describe(f, c.pose);
  f.number("t", c.time, kFinite, 0);
}

void describe(Fields& f, StopStroke& c) {
  f.number("moves", c.moves, {0, kMostMoves});
  f.whole("ticks", c.ticks, 0, kMostTicks, 0);
}

std::string Recut::words() const { return "Cut the stroke again, " + fineness(settings.resolution); }

void describe(Fields& f, Recut& c) { f.object("settings", c.settings); }

}  // namespace kerf
