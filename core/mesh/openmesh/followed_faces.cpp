#include "core/mesh/openmesh/followed_faces.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "core/mesh/point_to_triangle.h"

namespace kerf {

namespace {

using Face = OpenMeshKernel::FaceHandle;

std::array<Vec3, 4> middles_of_quarters(const Triangle& t) {
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  return {0.5 * (middle + t[0]), 0.5 * (middle + t[1]), 0.5 * (middle + t[2]), middle};
}

Face nearest_to(const Vec3& p, std::span<const FollowedFaces::Changed> changed) {
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

FollowedFaces::FollowedFaces(const Mesh& mesh, const Sheets& sheets, std::span<const FaceId> faces)
    : faces_(faces.begin(), faces.end()) {
  if (faces_.empty()) return;
  lying_.assign(sheets.faces.size(), kNone);
  for (const FaceId f : faces_) {
    const auto handle = std::lower_bound(sheets.faces.begin(), sheets.faces.end(), f) - sheets.faces.begin();
    KERF_ASSERT(sheets.faces[static_cast<size_t>(handle)] == f);
    Triangle corners = mesh.triangle(f);
    for (Vec3& p : corners) p = sheets.frame.scaled(p);
    for (const Vec3& middle : middles_of_quarters(corners)) {
      next_.push_back(
          std::exchange(lying_[static_cast<size_t>(handle)], static_cast<uint32_t>(next_.size())));
      middles_.push_back(middle);
    }
  }
}

void FollowedFaces::hand_on(std::span<const Face> before, std::span<const Changed> changed) {
  KERF_ASSERT(!before.empty() && !changed.empty());
  std::vector<uint32_t> quarters;
  for (const Face f : before) {
    for (uint32_t q = std::exchange(lying_[static_cast<size_t>(f.idx())], kNone); q != kNone; q = next_[q])
      quarters.push_back(q);
  }
  for (const uint32_t q : quarters) {
    const Face f = nearest_to(middles_[q], changed);
    next_[q] = std::exchange(lying_[static_cast<size_t>(f.idx())], q);
  }
}

std::vector<FollowedFace> FollowedFaces::places(const Sheets& sheets) const {
  std::vector<FollowedFace> places;
  for (const FaceId f : faces_) places.push_back({f, {}});
  for (size_t handle = 0; handle < lying_.size(); ++handle) {
    for (uint32_t q = lying_[handle]; q != kNone; q = next_[q])
      places[q / 4].quarters[q % 4] = sheets.faces[handle];
  }
  return places;
}

}  // namespace kerf
