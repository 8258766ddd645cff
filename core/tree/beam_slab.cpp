#include "core/tree/beam_slab.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/base/tolerances.h"

namespace kerf {

namespace {

// The interval of one axis of the beam's slab in the frame of the tree, widened by all rounding errors.
SlabQuery::Axis tree_axis(const TreeStore& tree, double reach, const Vec3& axis, const Vec3& slab_origin,
                          Interval interval) {
  SlabQuery::Axis a;
  for (uint32_t k = 0; k < 3; ++k) {
    a.direction[k] = static_cast<float>(axis[static_cast<int>(k)]);
    a.low_plane[k] = a.direction[k] >= 0 ? k : k + 3;
    a.high_plane[k] = a.direction[k] >= 0 ? k + 3 : k;
  }
  const double scale = tree.frame.scale;
  const Vec3 from = (slab_origin - tree.frame.origin) * scale;
  const double base = glm::dot(axis, from), low = interval.low * scale, high = interval.high * scale;
  const double slack =
      reach * kProjectionRoundings + kBoxSlack * (8 * reach + std::abs(from.x) + std::abs(from.y) +
                                                  std::abs(from.z) + std::abs(low) + std::abs(high));
  const double most = 8 * reach;
  a.low = static_cast<float>(std::clamp(base + low - slack, -most, most));
  a.high = static_cast<float>(std::clamp(base + high + slack, -most, most));
  return a;
}

// A corner of the box around the tree, in the frame of the mesh.
Vec3 corner(const TreeStore& tree, __m128 p) {
  alignas(16) float xyz[4];
  _mm_store_ps(xyz, p);
  return tree.frame.to_mesh(Vec3(xyz[0], xyz[1], xyz[2]));
}

}  // namespace

// Depths beyond the tree are cut off, so that the far end of a tilting beam does not widen the slab.
SlabQuery beam_slab(const TreeStore& tree, const SweptCylinder& beam) {
  assert(tree.root != kNoIndex);
  const Vec3 low = corner(tree, tree.root_box().low), high = corner(tree, tree.root_box().high);
  const SweptCylinder::Slab open =
      beam.slab({std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()});
  const Vec3 centre = 0.5 * low + 0.5 * high - open.origin, half = 0.5 * (high - low);
  const double depth = glm::dot(open.axis, centre),
               deep = (1 + kBoxSlack) * glm::dot(glm::abs(open.axis), half);
  const SweptCylinder::Slab slab = beam.slab({depth - deep, depth + deep});
  const double reach = tree.reach();
  return {{tree_axis(tree, reach, slab.axis, slab.origin, slab.depth),
           tree_axis(tree, reach, slab.along, slab.origin, slab.motion),
           tree_axis(tree, reach, slab.across, slab.origin, slab.lateral)}};
}

}  // namespace kerf
