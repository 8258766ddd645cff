#include "ui/editor/shared/laser/laser_controls.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

Resolution ResolutionControls::of(double radius) const {
  KERF_ASSERT(radius > 0);
  Resolution resolution;
  resolution.rule = rule;
  resolution.scheme = scheme;
  resolution.rim = rim;
  resolution.target_edge = radius * edge_fraction;
  resolution.tolerance = radius * tolerance_fraction;
  resolution.depth = depth;
  return resolution;
}

void ResolutionControls::show(const Resolution& resolution, double radius) {
  KERF_ASSERT(radius > 0);
  const auto fraction = [&](double length) {
    return std::clamp(length / radius, kLeastFraction, kMostFraction);
  };
  scheme = resolution.scheme;
  rule = resolution.rule;
  rim = resolution.rim;
  if (rule == Resolution::Rule::kTargetEdge) edge_fraction = fraction(resolution.target_edge);
  if (rule == Resolution::Rule::kTolerance) tolerance_fraction = fraction(resolution.tolerance);
  if (rule == Resolution::Rule::kDepth) depth = std::clamp(resolution.depth, 0, kLargestDepth);
}

void LaserControls::show(const CutSettings& settings) {
  const double cut = settings.laser.radius;
  radius = std::clamp(cut, default_radius / kRadiusSpan, default_radius * kRadiusSpan);
  resolution.show(settings.resolution, cut);
}

void make_finer(ResolutionControls& controls, int steps) {
  using Controls = ResolutionControls;
  const auto divide = [&](double& fraction) {
    fraction = std::clamp(std::ldexp(fraction, -steps), Controls::kLeastFraction, Controls::kMostFraction);
  };
  switch (controls.rule) {
    case Resolution::Rule::kTargetEdge:
      return divide(controls.edge_fraction);
    case Resolution::Rule::kTolerance:
      return divide(controls.tolerance_fraction);
    case Resolution::Rule::kDepth:
      controls.depth = std::clamp(controls.depth + steps, 0, Controls::kLargestDepth);
  }
}

CutSettings LaserControls::settings(double diagonal) const {
  CutSettings settings;
  settings.laser = beam();
  settings.laser.range = {0, 10 * diagonal};
  settings.model = model;
  if (model == Model::kGeometric) settings.heat_width = width_of_heat();
  settings.resolution = resolution.of(radius);
  return settings;
}

}  // namespace kerf
