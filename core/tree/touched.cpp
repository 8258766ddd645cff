#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/base/tolerances.h"
#include "core/tree/aabb_tree.h"
#include "core/tree/walk_scratch.h"

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

void mark(TreeStore& tree, std::span<const uintptr_t> marks) {
  assert(marks.size() % 2 == 0);
  for (size_t i = 0; i < marks.size(); i += 2) {
    const auto bits = static_cast<unsigned>(marks[i + 1]);
    if (marks_block(marks[i]))
      tree.mark(*reinterpret_cast<const FaceBlock*>(marks[i] - 1), bits);
    else
      tree.mark(*reinterpret_cast<const WideNode*>(marks[i]), bits);
  }
}

}  // namespace

QueryCounts AabbTree::touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out) {
  QueryCounts counts;
  if (store_.root == kNoIndex) return counts;
  // Depths beyond the tree are cut off, so that the far end of a tilting beam does not widen the slab.
  const Box all = bounds();
  const SweptCylinder::Slab open =
      beam.slab({std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()});
  const Vec3 centre = 0.5 * all.min + 0.5 * all.max - open.origin, half = 0.5 * (all.max - all.min);
  const double depth = glm::dot(open.axis, centre),
               deep = (1 + kBoxSlack) * glm::dot(glm::abs(open.axis), half);
  const SweptCylinder::Slab slab = beam.slab({depth - deep, depth + deep});

  const double reach = store_.reach();
  const SlabQuery query{{tree_axis(store_, reach, slab.axis, slab.origin, slab.depth),
                         tree_axis(store_, reach, slab.along, slab.origin, slab.motion),
                         tree_axis(store_, reach, slab.across, slab.origin, slab.lateral)}};
  WalkScratch scratch;
  counts.boxes = walks_->slab(store_.view(), query, scratch);
  counts.faces = scratch.found().size();
  mark(store_, scratch.met());
  store_.root_hit = store_.root_hit || store_.nodes[store_.root].hit != 0;
  for (const uintptr_t word : scratch.found()) {
    const FaceId f(block_of(word)->face[lane_of(word)]);
    if (beam.touches(mesh.triangle(f))) out.push_back(f);
  }
  return counts;
}

}  // namespace kerf
