#include "core/mesh/remesh/surface_samples.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/mesh/point_to_triangle.h"

namespace kerf {

SurfaceSamples::SurfaceSamples(const FlatSurface& surface) : first_(surface.faces(), kNoIndex) {
  for (uint32_t f = 0; f < surface.faces(); ++f) {
    if (!surface.has(f)) continue;
    const auto& [a, b, c] = surface.corners(f);
    add(f, (surface.point(a) + surface.point(b) + surface.point(c)) / 3.0);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (from < to)  // on boundaries, which stay, it does not matter whether there is one
        add(f, 0.5 * (surface.point(from) + surface.point(to)));
    }
  }
}

void SurfaceSamples::add(uint32_t face, const Vec3& p) {
  next_.push_back(std::exchange(first_[face], static_cast<uint32_t>(points_.size())));
  points_.push_back(p);
}

bool SurfaceSamples::are_near(std::span<const uint32_t> before, const Vec3& gone,
                              std::span<const FollowedFaces::Changed> changed) const {
  // Beginning with the face that was near enough to the sample before.
  size_t last = 0;
  const auto near = [&](const Vec3& p) {
    for (size_t tried = 0; tried < changed.size(); ++tried) {
      if (squared_distance(p, changed[last].corners) <= most2_) return true;
      last = last + 1 == changed.size() ? 0 : last + 1;
    }
    return false;
  };
  if (!near(gone)) return false;
  for (const uint32_t f : before) {
    for (uint32_t s = first_[f]; s != kNoIndex; s = next_[s]) {
      if (!near(points_[s])) return false;
    }
  }
  return true;
}

void SurfaceSamples::hand_on(std::span<const uint32_t> before, const Vec3& gone,
                             std::span<const FollowedFaces::Changed> changed) {
  KERF_ASSERT(!changed.empty());
  const auto nearest = [&](const Vec3& p) {
    return std::min_element(changed.begin(), changed.end(),
                            [&](const auto& a, const auto& b) {
                              return squared_distance(p, a.corners) < squared_distance(p, b.corners);
                            })
        ->face;
  };
  std::vector<uint32_t> moved;
  for (const uint32_t f : before) {
    for (uint32_t s = std::exchange(first_[f], kNoIndex); s != kNoIndex; s = next_[s]) moved.push_back(s);
  }
  for (const uint32_t s : moved) next_[s] = std::exchange(first_[nearest(points_[s])], s);
  add(nearest(gone), gone);
}

}  // namespace kerf
