#include "ui/editor/shared/first_picture.h"

#include <cmath>

#include "core/base/assert.h"
#include "core/base/unit_vector.h"

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

Vec3 dragged_around(const FirstPicture& picture, const Vec3& pivot, double distance, const Vec3& now,
                    Vec2 place) {
  KERF_ASSERT(distance > 0);
  const Pose ray = picture.ray(place);
  const bool away = glm::dot(now - pivot, ray.direction) > 0;
  const Vec3 from = ray.origin - pivot;
  const Vec3 nearest = from - ray.direction * glm::dot(from, ray.direction);
  const double inside = distance * distance - glm::dot(nearest, nearest);
  if (inside <= 0) return pivot + glm::normalize(nearest) * distance;
  return pivot + nearest + ray.direction * ((away ? 1.0 : -1.0) * std::sqrt(inside));
}

double dragged_along(const FirstPicture& picture, const Vec3& pivot, const Vec3& direction, Vec2 from,
                     Vec2 to) {
  KERF_ASSERT(is_unit(direction));
  const auto begin = picture.place_of(pivot);
  const auto end = picture.place_of(pivot + direction * picture.metres_of_em(pivot));
  if (!begin || !end) return 0;
  const Vec2 way = *end - *begin;  // in the window, of a line as long as the text is high
  const double length2 = glm::dot(way, way);
  return length2 > 1 ? glm::dot(to - from, way) / length2 * picture.metres_of_em(pivot) : 0;
}

}  // namespace kerf
