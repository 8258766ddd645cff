#include "ui/editor/shared/picture/first_picture.h"

namespace kerf {

std::optional<Vec2> FirstPicture::place_of(const Vec3& p) const {
  const Vec3 seen = camera_.project(p);
  if (seen.z <= 0) return std::nullopt;
  return area_.at + Vec2(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y) * area_.size;
}

double FirstPicture::metres_of_em(const Vec3& p) const {
  const double depth = camera_.parallel ? camera_.focus : camera_.project(p).z;
  return 2 * depth * camera_.tan_half_fov / area_.size.y * em_;
}

Pose FirstPicture::ray(Vec2 place) const {
  const Vec2 p = (place - area_.at) / area_.size;
  return camera_.ray(2 * p.x - 1, 1 - 2 * p.y);
}

Vec3 FirstPicture::at_depth_of(const Vec3& p, Vec2 place) const {
  const Pose through = ray(place);
  const double depth = glm::dot(p - through.origin, camera_.forward);
  return through.origin + through.direction * (depth / glm::dot(through.direction, camera_.forward));
}

}  // namespace kerf
