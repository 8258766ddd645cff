#include "core/physics/collider/simplify_line.h"

#include <algorithm>

namespace kerf {

namespace {

double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a, to = p - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(to, along) / length2, 0.0, 1.0) : 0;
  const Vec3 off = to - t * along;
  return glm::dot(off, off);
}

}  // namespace

std::vector<Vec3> simplified(const std::vector<Vec3>& line, double error) {
  if (line.size() < 3) return line;
  const bool closed = line.front() == line.back();
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<size_t, size_t>> parts{{0, line.size() - 1}};
  bool must_divide = closed;
  while (!parts.empty()) {
    const auto [first, last] = parts.back();
    parts.pop_back();
    size_t farthest = first;
    double most = must_divide ? 0 : error * error;
    for (size_t i = first + 1; i < last; ++i) {
      const double d = squared_distance_to_segment(line[i], line[first], line[last]);
      if (d > most) {
        most = d;
        farthest = i;
      }
    }
    must_divide = false;
    if (farthest == first) continue;
    kept[farthest] = true;
    parts.emplace_back(first, farthest);
    parts.emplace_back(farthest, last);
  }
  std::vector<Vec3> few;
  for (size_t i = 0; i < line.size(); ++i) {
    if (kept[i]) few.push_back(line[i]);
  }
  return few;
}

}  // namespace kerf
