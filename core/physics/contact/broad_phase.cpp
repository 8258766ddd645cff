#include "core/physics/contact/broad_phase.h"

#include <algorithm>
#include <numeric>

namespace kerf {

namespace {

int widest_axis(std::span<const MovingBody> bodies) {
  Box corners;
  for (const MovingBody& b : bodies) corners.add(b.bounds.min);
  const Vec3 extent = corners.max - corners.min;
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

}  // namespace

std::vector<std::pair<uint32_t, uint32_t>> near_pairs(std::span<const MovingBody> bodies) {
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  if (bodies.empty()) return pairs;
  const int axis = widest_axis(bodies);
  std::vector<uint32_t> order(bodies.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return bodies[a].bounds.min[axis] < bodies[b].bounds.min[axis];
  });
  for (size_t i = 0; i < order.size(); ++i) {
    const MovingBody& a = bodies[order[i]];
    for (size_t j = i + 1; j < order.size() && bodies[order[j]].bounds.min[axis] <= a.bounds.max[axis]; ++j) {
      const MovingBody& b = bodies[order[j]];
      if ((a.moves() || b.moves()) && a.bounds.overlaps(b.bounds))
        pairs.push_back(std::minmax(order[i], order[j]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace kerf
