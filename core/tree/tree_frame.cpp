#include "core/tree/tree_frame.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/mesh/mesh_bounds.h"

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

Result<TreeFrame> TreeFrame::around(const Mesh& mesh, const Progress* progress) {
  const auto bounds = bounds_of(mesh, progress);
  if (!bounds) return bounds.error();
  const auto& [low, high] = *bounds;
  TreeFrame frame;
  if (low.x > high.x) return frame;
  frame.origin = 0.5 * low + 0.5 * high;
  const Vec3 half = high - frame.origin;
  const double extent = std::max({half.x, half.y, half.z});
  if (extent > 0) frame.scale = power_of_two_over(extent);
  return frame;
}

}  // namespace kerf
