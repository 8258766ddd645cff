#include "ui/window/layout.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {
constexpr double kLeastViewport = 320, kLeastViewportHeight = 160;
constexpr double kLeastSideEms = 12, kLeastStripEms = 6;
constexpr double kLeastHalf = 120;

// What an area of panels gets of the room that the picture can spare; none if that would not be usable.
double share(double wanted_ems, double least_ems, double em, double room) {
  const double size = std::min(std::round(wanted_ems * em), std::floor(room));
  return size < std::min(wanted_ems, least_ems) * em ? 0 : std::max(size, 0.0);
}
}  // namespace

Layout lay_out(Vec2 window, double em, double menu, double status, const PanelSizes& panels) {
  const double height = std::max(1.0, window.y - menu - status);
  const double side = share(panels.side, kLeastSideEms, em, window.x - kLeastViewport);
  const double second = share(panels.second_side, kLeastSideEms, em, window.x - side - kLeastViewport);
  const double strip = share(panels.strip, kLeastStripEms, em, height - kLeastViewportHeight);
  const double width = std::max(1.0, window.x - side - second);
  Layout layout;
  layout.viewport = {{second, menu}, {width, height - strip}};
  layout.side = {{window.x - side, menu}, {side, height}};
  layout.second_side = {{0, menu}, {second, height}};
  layout.strip = {{second, menu + height - strip}, {width, strip}};
  layout.status = {{0, menu + height}, {window.x, status}};
  layout.first = layout.viewport;
  layout.em = em;
  return layout;
}

Layout split_in_two(Layout whole, double share) {
  KERF_ASSERT(!whole.split() && share >= 0 && share <= 1);
  const Area& all = whole.viewport;
  const double least = std::min(kLeastHalf, std::floor(0.5 * all.size.x));
  const double left = std::clamp(std::round(share * all.size.x), least, all.size.x - least);
  whole.first = {all.at, {left, all.size.y}};
  whole.second = {{all.at.x + left, all.at.y}, {all.size.x - left, all.size.y}};
  return whole;
}

}  // namespace kerf
