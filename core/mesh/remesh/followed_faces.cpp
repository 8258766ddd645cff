#include "core/mesh/remesh/followed_faces.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "core/mesh/point_to_triangle.h"

namespace kerf {

namespace {

std::array<Vec3, 4> middles_of_quarters(const Triangle& t) {
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  return {0.5 * (middle + t[0]), 0.5 * (middle + t[1]), 0.5 * (middle + t[2]), middle};
}

uint32_t nearest_to(const Vec3& p, std::span<const FollowedFaces::Changed> changed) {
  const FollowedFaces::Changed* nearest = &changed.front();
  double least = squared_distance(p, nearest->corners);
  for (const FollowedFaces::Changed& face : changed.subspan(1)) {
    const double distance2 = squared_distance(p, face.corners);
    if (distance2 >= least) continue;
    least = distance2;
    nearest = &face;
  }
  return nearest->face;
}

}  // namespace

FollowedFaces::FollowedFaces(const Mesh& mesh, const FloatFrame& frame, std::span<const FaceId> numbers,
                             std::span<const FaceId> faces)
    : faces_(faces.begin(), faces.end()) {
  if (faces_.empty()) return;
  lying_.assign(numbers.size(), kNone);
  for (const FaceId f : faces_) {
    const auto at = std::lower_bound(numbers.begin(), numbers.end(), f);
    KERF_ASSERT(at != numbers.end() && *at == f);
    uint32_t& lying = lying_[static_cast<size_t>(at - numbers.begin())];
    Triangle corners = mesh.triangle(f);
    for (Vec3& p : corners) p = frame.scaled(p);
    for (const Vec3& middle : middles_of_quarters(corners)) {
      next_.push_back(std::exchange(lying, static_cast<uint32_t>(next_.size())));
      middles_.push_back(middle);
    }
  }
}

void FollowedFaces::hand_on(std::span<const uint32_t> before, std::span<const Changed> changed) {
  KERF_ASSERT(!before.empty() && !changed.empty());
  std::vector<uint32_t> quarters;
  for (const uint32_t f : before) {
    for (uint32_t q = std::exchange(lying_[f], kNone); q != kNone; q = next_[q]) quarters.push_back(q);
  }
  for (const uint32_t q : quarters) {
    const uint32_t f = nearest_to(middles_[q], changed);
    next_[q] = std::exchange(lying_[f], q);
  }
}

std::vector<FollowedFace> FollowedFaces::places(std::span<const FaceId> numbers) const {
  std::vector<FollowedFace> places;
  for (const FaceId f : faces_) places.push_back({f, {}});
  for (size_t f = 0; f < lying_.size(); ++f) {
    for (uint32_t q = lying_[f]; q != kNone; q = next_[q]) places[q / 4].quarters[q % 4] = numbers[f];
  }
  return places;
}

}  // namespace kerf
