#include "core/physics/contact/broad_phase.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"

namespace kerf {

namespace {

int widest_axis(std::span<const MovingBody> bodies) {
  Box corners;
  for (const MovingBody& b : bodies) corners.add(b.bounds.min);
  return corners.widest_axis();
}

// Whether the bounds of one body on its way overlap those of another in the frame of the other: tilted sheets
// have small bounds in their own frames and large ones in the world. Either may go its way or stay.
bool meets_in_frame_of(const MovingBody& other, const MovingBody& b) {
  KERF_ASSERT(other.margin >= 0 && b.margin >= 0);
  Box way;
  for (const RigidMap* to : {&other.now, &other.next}) {
    for (const RigidMap* from : {&b.now, &b.next}) way.add(moved(into(*to, *from), b.collider->bounds));
  }
  return way.wider(std::min(other.margin, b.margin)).overlaps(other.collider->bounds);
}

bool can_touch(const MovingBody& a, const MovingBody& b) {
  return (a.moves() || b.moves()) && !(a.glides && b.fixed) && !(b.glides && a.fixed);
}

bool are_near(const MovingBody& a, const MovingBody& b) {
  return can_touch(a, b) && a.bounds.overlaps(b.bounds) && meets_in_frame_of(a, b) && meets_in_frame_of(b, a);
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
      if (are_near(a, bodies[order[j]])) pairs.push_back(std::minmax(order[i], order[j]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace kerf
