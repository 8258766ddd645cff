#include "core/game/vehicle/face_watch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/mesh/measures.h"

namespace kerf {

namespace {

uint32_t part_of_group(const std::string& group, const std::vector<std::string>& parts) {
  auto best = static_cast<uint32_t>(parts.size());
  for (uint32_t p = 0; p < parts.size(); ++p) {
    const bool longer = best == parts.size() || parts[p].size() > parts[best].size();
    if (longer && is_of_part(group, parts[p])) best = p;
  }
  return best;
}

}  // namespace

std::vector<uint32_t> part_of_triangles(const Soup& soup, const std::vector<std::string>& parts) {
  std::vector<uint32_t> of(soup.triangles.size(), static_cast<uint32_t>(parts.size()));
  for (const MeshPart& group : soup.parts) {
    const uint32_t part = part_of_group(group.name, parts);
    if (part == parts.size()) continue;
    for (uint32_t t = group.first; t < group.last; ++t) of[t] = part;
  }
  return of;
}

Soup extract_part(const Soup& soup, const std::vector<uint32_t>& part, uint32_t wanted) {
  KERF_ASSERT(part.size() == soup.triangles.size());
  Soup own;
  own.positions = soup.positions;
  own.material_names = soup.material_names;
  own.format = soup.format;
  std::vector<uint32_t> before(part.size() + 1, 0);  // triangles of the part before each one
  for (size_t t = 0; t < part.size(); ++t) {
    before[t + 1] = before[t] + (part[t] == wanted ? 1 : 0);
    if (part[t] != wanted) continue;
    own.triangles.push_back(soup.triangles[t]);
    if (!soup.materials.empty()) own.materials.push_back(soup.materials[t]);
  }
  for (const MeshPart& group : soup.parts) {
    const uint32_t first = before[group.first], last = before[group.last];
    if (first < last) own.parts.push_back({group.name, first, last});
  }
  own.faces_in_file = own.triangles_in_file = own.triangles.size();
  return own;
}

namespace {

// Returns true if all corners of the triangle lie in the ball.
bool is_inside(const Triangle& t, const Ball& ball) {
  return std::all_of(t.begin(), t.end(),
                     [&](const Vec3& p) { return glm::distance(p, ball.centre) <= ball.radius; });
}

}  // namespace

double area_within(const Triangle& t, const Ball& ball) {
  if (squared_distance(ball.centre, t) > ball.radius * ball.radius) return 0;
  if (is_inside(t, ball)) return triangle_area(t);
  size_t longest = 0;
  for (size_t i = 1; i < 3; ++i) {
    if (glm::distance(t[i], t[(i + 1) % 3]) > glm::distance(t[longest], t[(longest + 1) % 3])) longest = i;
  }
  const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
  if (glm::distance(a, b) < 0.2 * ball.radius) return 0.5 * triangle_area(t);
  const Vec3 middle = 0.5 * (a + b);
  return area_within({a, middle, c}, ball) + area_within({middle, b, c}, ball);
}

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
  KERF_ASSERT(areas_.size() < kMaxGroups && groups_of_.size() == loaded.mesh.face_slots());
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
