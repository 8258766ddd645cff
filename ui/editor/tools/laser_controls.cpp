#include "ui/editor/tools/laser_controls.h"

namespace kerf {

Resolution ResolutionControls::of(double radius) const {
  Resolution resolution;
  resolution.rule = rule;
  resolution.scheme = scheme;
  resolution.rim = rim;
  resolution.target_edge = radius * edge_fraction;
  resolution.tolerance = radius * tolerance_fraction;
  resolution.depth = depth;
  return resolution;
}

CutSettings LaserControls::settings(double diagonal) const {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, 10 * diagonal};
  settings.laser.pattern = pattern;
  settings.resolution = resolution.of(radius);
  return settings;
}

}  // namespace kerf
