#include "ui/editor/laser_controls.h"

namespace kerf {

CutSettings LaserControls::settings(double diagonal) const {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, 10 * diagonal};
  settings.laser.pattern = pattern;
  settings.resolution = {rule, radius * edge_fraction, depth};
  return settings;
}

}  // namespace kerf
