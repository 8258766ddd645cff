#include "core/physics/collider/simplify_line.h"

#include <algorithm>
#include <limits>

#include "core/base/assert.h"

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

std::vector<double> left_out_from(const std::vector<Vec3>& line, double least_error) {
  KERF_ASSERT(least_error >= 0);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (line.size() < 3) return std::vector<double>(line.size(), kInfinity);
  std::vector<double> from(line.size(), 0);
  from.front() = from.back() = kInfinity;
  struct Part {
    size_t first, last;
    double most;  // for larger squared errors the part is not divided
  };
  std::vector<Part> parts{{0, line.size() - 1, kInfinity}};
  bool must_divide = line.front() == line.back();
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    size_t farthest = part.first;
    double most = must_divide ? 0 : least_error * least_error;
    for (size_t i = part.first + 1; i < part.last; ++i) {
      const double d = squared_distance_to_segment(line[i], line[part.first], line[part.last]);
      if (d > most) {
        most = d;
        farthest = i;
      }
    }
    if (farthest != part.first) {
      from[farthest] = must_divide ? kInfinity : std::min(part.most, most);
      parts.push_back({part.first, farthest, from[farthest]});
      parts.push_back({farthest, part.last, from[farthest]});
    }
    must_divide = false;
  }
  return from;
}

std::vector<Vec3> simplified(const std::vector<Vec3>& line, double error) {
  const std::vector<double> from = left_out_from(line, error);
  std::vector<Vec3> few;
  for (size_t i = 0; i < line.size(); ++i) {
    if (from[i] > error * error) few.push_back(line[i]);
  }
  return few;
}

}  // namespace kerf
