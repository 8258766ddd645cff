#include "core/document/text/settings_fields.h"

#include <array>

#include "core/document/text/fields.h"

namespace kerf {

namespace {

constexpr std::array kPatterns{"volume", "rays4"};
constexpr std::array kSchemes{"one-to-four", "longest-edge"};
constexpr std::array kRules{"target-edge", "tolerance", "depth"};
constexpr std::array kRims{"faces", "smooth"};
constexpr std::array kModels{"geometric", "thermal"};

}  // namespace

void describe(Fields& f, CutSettings& s) {
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
  f.whole("most-faces", s.most_faces, 1, uint64_t{1} << 32, 20'000'000);
  f.no_others("is not a setting that this version has");
}

}  // namespace kerf
