#include "core/tree/tree_frame.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {

// The reciprocal of the largest power of two not above x, limited so that it stays finite. Precondition: x is
// positive and finite.
double power_of_two_over(double x) {
  KERF_ASSERT(x > 0 && std::isfinite(x));
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0, std::min(1 - exponent, 1000));
}

}  // namespace

TreeFrame TreeFrame::around(const Bounds& bounds) {
  TreeFrame frame;
  if (bounds.is_none()) return frame;
  frame.origin = bounds.centre();
  const Vec3 half = bounds.max - frame.origin;
  const double extent = std::max({half.x, half.y, half.z});
  if (extent > 0) frame.scale = power_of_two_over(extent);
  return frame;
}

}  // namespace kerf
