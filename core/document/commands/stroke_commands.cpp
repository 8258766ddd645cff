#include "core/document/commands/stroke_commands.h"

#include <array>

#include "core/document/text/fields.h"
#include "core/document/text/world_fields.h"
#include "core/mesh/files/length_label.h"

namespace kerf {

namespace {

constexpr std::array kPatterns{"volume", "rays4"};
constexpr std::array kSchemes{"one-to-four", "longest-edge"};
constexpr std::array kRules{"target-edge", "tolerance", "depth"};
constexpr std::array kRims{"faces", "smooth"};
constexpr std::array kAssists{"none", "oxygen"};
constexpr std::array kModels{"geometric", "thermal"};

constexpr double kMostMoves = 1e9;
constexpr Ticks kMostTicks = Ticks{1} << 40;

std::string fineness(const Resolution& r, FileUnit unit) {
  switch (r.rule) {
    case Resolution::Rule::kTargetEdge:
      return "edges of " + length_label(r.target_edge, unit);
    case Resolution::Rule::kTolerance:
      return "within " + length_label(r.tolerance, unit);
    case Resolution::Rule::kDepth:
      return std::to_string(r.depth) + (r.depth == 1 ? " level" : " levels");
  }
  return "";
}

}  // namespace

// The settings of a stroke with everything that the result of its cut depends on.
static void describe(Fields& f, CutSettings& s) {
  f.number("radius", s.laser.radius, kPositive);
  f.interval("range", s.laser.range);
  f.choice("pattern", s.laser.pattern, kPatterns);
  f.number("power", s.laser.power, kPositive);
  f.choice("scheme", s.resolution.scheme, kSchemes);
  f.choice("rule", s.resolution.rule, kRules);
  f.number("target-edge", s.resolution.target_edge, kPositive);
  f.number("tolerance", s.resolution.tolerance, kPositive);
  f.whole("depth", s.resolution.depth, 0, Resolution::kLargestDepth);
  f.choice("rim", s.resolution.rim, kRims);
  f.choice("model", s.model, kModels, Model::kGeometric);
  f.number("heat-width", s.heat_width, kPositive, 0);
  f.number("wavelength", s.laser.wavelength, kPositive, 0);
  f.number("focus", s.laser.focus, kPositive);
  f.number("pulse-rate", s.laser.pulse_rate, kPositive, 0);
  f.number("duty", s.laser.duty, kPositiveShare, 1);
  f.choice("assist", s.laser.assist, kAssists, Assist::kNone);
  f.whole("most-faces", s.most_faces, 1, uint64_t{1} << 32, CutSettings::kMostFaces);
}

std::string BeginStroke::words(FileUnit unit) const {
  return "Stroke, radius " + length_label(settings.laser.radius, unit) +
         (settings.laser.pattern == Pattern::kRays4 ? ", four rays" : "");
}

void describe(Fields& f, BeginStroke& c) {
  f.object("settings", c.settings);
  describe(f, c.pose);
}

void describe(Fields& f, MoveBeam& c) {
  describe(f, c.pose);
  f.number("t", c.time, kFinite, 0);
}

void describe(Fields& f, StopStroke& c) {
  f.number("moves", c.moves, {0, kMostMoves});
  f.whole("ticks", c.ticks, 0, kMostTicks, 0);
}

std::string Recut::words(FileUnit unit) const {
  return "Cut the stroke again, " + fineness(settings.resolution, unit);
}

void describe(Fields& f, Recut& c) { f.object("settings", c.settings); }

}  // namespace kerf
