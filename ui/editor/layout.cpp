#include "ui/editor/layout.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {
constexpr double kLeastViewport = 320;
constexpr double kLeastSideEms = 12;
}  // namespace

Layout lay_out(Vec2 window, double em, double menu, double status, double side_ems) {
  double side = std::min(std::round(side_ems * em), window.x - kLeastViewport);
  if (side < std::min(side_ems, kLeastSideEms) * em) side = 0;
  const double height = std::max(1.0, window.y - menu - status);
  Layout layout;
  layout.viewport = {{0, menu}, {std::max(1.0, window.x - side), height}};
  layout.side = {{window.x - side, menu}, {side, height}};
  layout.status = {{0, menu + height}, {window.x, status}};
  return layout;
}

}  // namespace kerf
