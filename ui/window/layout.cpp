#include "ui/window/layout.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {
constexpr double kLeastViewport = 320;
constexpr double kLeastSideEms = 12;
constexpr double kLeastHalf = 120;
}  // namespace

Layout lay_out(Vec2 window, double em, double menu, double status, double side_ems) {
  double side = std::min(std::round(side_ems * em), window.x - kLeastViewport);
  if (side < std::min(side_ems, kLeastSideEms) * em) side = 0;
  const double height = std::max(1.0, window.y - menu - status);
  Layout layout;
  layout.viewport = {{0, menu}, {std::max(1.0, window.x - side), height}};
  layout.side = {{window.x - side, menu}, {side, height}};
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
