#include "core/document/stroke_settings.h"

namespace kerf {

CutSettings default_settings(const StrokePath& stroke, double diagonal) {
  CutSettings settings;
  settings.laser.radius = stroke.radius.value_or(diagonal / 400);
  settings.laser.range = stroke.range.value_or(Interval{0, 10 * diagonal});
  settings.laser.power = stroke.power.value_or(settings.laser.power);
  settings.resolution.target_edge = settings.laser.radius / 4;
  settings.resolution.tolerance = settings.laser.radius / 8;
  return settings;
}

}  // namespace kerf
