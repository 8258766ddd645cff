#include "core/game/vehicle/face_watch.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

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

size_t FaceWatch::add(const Body& loaded, const std::function<bool(FaceId)>& belongs) {
  assert(areas_.size() < kMostGroups && groups_of_.size() == loaded.mesh.face_slots());
  const size_t group = areas_.size();
  double area = 0;
  for (uint32_t f = 0; f < loaded.mesh.face_slots(); ++f) {
    if (!belongs(FaceId(f))) continue;
    groups_of_[f] |= uint32_t{1} << group;
    area += triangle_area(loaded.mesh.triangle(FaceId(f)));
  }
  areas_.push_back(area);
  return group;
}

size_t FaceWatch::add_part(const Body& loaded, const std::string& part) {
  const std::vector<bool> of = faces_of_part(loaded, part);
  return add(loaded, [&](FaceId f) { return of[f.index]; });
}

size_t FaceWatch::add_part_near(const Body& loaded, const std::string& part, const Vec3& point) {
  const std::vector<bool> of = faces_of_part(loaded, part);
  std::vector<double> distance(of.size(), std::numeric_limits<double>::infinity());
  double nearest = std::numeric_limits<double>::infinity();
  for (uint32_t f = 0; f < of.size(); ++f) {
    if (!of[f]) continue;
    distance[f] = std::sqrt(squared_distance(point, loaded.mesh.triangle(FaceId(f))));
    nearest = std::min(nearest, distance[f]);
  }
  const double reach = std::max(1.25 * nearest, nearest + 0.1);
  return add(loaded, [&](FaceId f) { return distance[f.index] <= reach; });
}

std::vector<double> FaceWatch::areas_in(const Body& body) const {
  std::vector<double> areas(areas_.size(), 0);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    uint32_t groups = groups_of_[body.loaded_face(body.mesh.data(FaceId(f)).base).index];
    if (groups == 0) continue;
    const double area = triangle_area(body.mesh.triangle(FaceId(f)));
    for (; groups != 0; groups &= groups - 1) areas[std::countr_zero(groups)] += area;
  }
  return areas;
}

}  // namespace kerf
