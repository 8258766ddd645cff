#include "core/game/vehicle/face_watch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/game/vehicle/soup_parts.h"
#include "core/mesh/point_to_triangle.h"

namespace kerf {

namespace {

std::vector<bool> faces_of_part(const Body& loaded, const std::string& part) {
  std::vector<bool> of(loaded.mesh.face_slots(), false);
  for (const MeshPart& group : loaded.named_parts) {
    if (!is_of_part(group.name, part)) continue;
    for (uint32_t f = group.first; f < group.last; ++f) of[f] = true;
  }
  return of;
}

}  // namespace

double FaceWatch::area_in(size_t group, const Triangle& t) const {
  return near_[group] ? area_within(t, *near_[group]) : triangle_area(t);
}

size_t FaceWatch::add(const Body& loaded, const std::vector<bool>& faces, const std::optional<Ball>& near) {
  KERF_ASSERT(areas_.size() < kMostGroups && groups_of_.size() == loaded.mesh.face_slots());
  const size_t group = areas_.size();
  near_.push_back(near);
  double area = 0;
  for (uint32_t f = 0; f < faces.size(); ++f) {
    const double own = faces[f] ? area_in(group, loaded.mesh.triangle(FaceId(f))) : 0;
    if (own > 0) groups_of_[f] |= uint32_t{1} << group;
    area += own;
  }
  areas_.push_back(area);
  return group;
}

size_t FaceWatch::add_part(const Body& loaded, const std::string& part) {
  return add(loaded, faces_of_part(loaded, part), std::nullopt);
}

size_t FaceWatch::add_part_near(const Body& loaded, const std::string& part, const Vec3& point) {
  const std::vector<bool> of = faces_of_part(loaded, part);
  double nearest2 = std::numeric_limits<double>::infinity();
  for (uint32_t f = 0; f < of.size(); ++f) {
    if (of[f]) nearest2 = std::min(nearest2, squared_distance(point, loaded.mesh.triangle(FaceId(f))));
  }
  if (nearest2 == std::numeric_limits<double>::infinity()) return add(loaded, of, std::nullopt);
  const double nearest = std::sqrt(nearest2);
  return add(loaded, of, Ball{point, std::max(1.25 * nearest, nearest + 0.1)});
}

std::vector<double> FaceWatch::areas_in(const Body& body) const {
  std::vector<double> areas(areas_.size(), 0);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    uint32_t groups = groups_of_[body.loaded_face(body.loaded_base(FaceId(f))).index];
    if (groups == 0) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    for (; groups != 0; groups &= groups - 1) {
      const auto group = static_cast<size_t>(std::countr_zero(groups));
      areas[group] += area_in(group, t);
    }
  }
  return areas;
}

}  // namespace kerf
