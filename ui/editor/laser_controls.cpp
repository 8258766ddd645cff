#include "ui/editor/laser_controls.h"

namespace kerf {

CutSettings LaserControls::settings(double diagonal) const {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, 10 * diagonal};
  settings.laser.pattern = pattern;
  settings.resolution = resolution(radius);
  return settings;
}

Resolution LaserControls::resolution(double beam_radius) const {
  Resolution resolution;
  resolution.rule = rule;
  resolution.target_edge = beam_radius * edge_fraction;
  resolution.depth = depth;
  return resolution;
}

}  // namespace kerf
