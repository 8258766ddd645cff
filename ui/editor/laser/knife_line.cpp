#include "ui/editor/laser/knife_line.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

namespace {

double distance_from_segment(Vec2 p, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double length2 = glm::dot(along, along);
  const double share = length2 > 0 ? std::clamp(glm::dot(p - from, along) / length2, 0.0, 1.0) : 0;
  return glm::length(p - from - share * along);
}

// Marks the points between two kept ones that simplified() keeps.
void keep_between(std::span<const Vec2> points, size_t from, size_t to, double tolerance,
                  std::vector<char>& kept) {
  std::vector<std::pair<size_t, size_t>> waiting{{from, to}};
  while (!waiting.empty()) {
    const auto [begin, end] = waiting.back();
    waiting.pop_back();
    size_t farthest = begin;
    double distance = tolerance;
    for (size_t i = begin + 1; i < end; ++i) {
      const double here = distance_from_segment(points[i], points[begin], points[end]);
      if (here > distance) distance = here, farthest = i;
    }
    if (farthest == begin) continue;
    kept[farthest] = true;
    waiting.emplace_back(begin, farthest);
    waiting.emplace_back(farthest, end);
  }
}

// Returns the share of the segment a to b at which it meets c to d; both are open at their ends b and d.
std::optional<double> crossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 along = b - a;
  const double across = cross2(along, d - c);
  const auto is_inside = [](double share) { return share >= 0 && share < 1; };
  if (across != 0) {
    const double of_ab = cross2(c - a, d - c) / across, of_cd = cross2(c - a, along) / across;
    return is_inside(of_ab) && is_inside(of_cd) ? std::optional(of_ab) : std::nullopt;
  }
  if (cross2(c - a, along) != 0 || along == Vec2(0)) return std::nullopt;
  const double of_c = glm::dot(c - a, along) / glm::dot(along, along);
  const double of_d = glm::dot(d - a, along) / glm::dot(along, along);
  if (is_inside(of_c)) return of_c;
  return (of_c < 0) != (of_d < 0) ? std::optional(0.0) : std::nullopt;
}

// Removes points of a closed curve at which it does not turn or turns back.
void remove_straight(std::vector<Vec2>& points) {
  for (size_t i = 0; points.size() > 2 && i < points.size();) {
    const size_t count = points.size();
    const Vec2 before = points[(i + count - 1) % count], after = points[(i + 1) % count];
    if (cross2(points[i] - before, after - points[i]) != 0) {
      ++i;
      continue;
    }
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
    i = i > 0 ? i - 1 : 0;
  }
}

double area_of(std::span<const Vec2> points) {
  double twice = 0;
  for (size_t i = 0; i < points.size(); ++i)
    twice += cross2(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
  return 0.5 * std::abs(twice);
}

// Splits a closed curve at its first crossing into its two loops and returns the larger one; nullopt if it
// has none.
std::optional<std::vector<Vec2>> without_a_loop(const std::vector<Vec2>& points) {
  const size_t count = points.size();
  const auto at = [&](size_t i) { return points[i % count]; };
  for (size_t i = 0; i < count; ++i) {
    for (size_t k = i + 2; k < count; ++k) {
      if (i == 0 && k + 1 == count) continue;
      const auto share = crossing(at(i), at(i + 1), at(k), at(k + 1));
      if (!share) continue;
      const Vec2 meeting = at(i) + *share * (at(i + 1) - at(i));
      const auto from = points.begin() + static_cast<std::ptrdiff_t>(i + 1);
      const auto to = points.begin() + static_cast<std::ptrdiff_t>(k + 1);
      std::vector<Vec2> inner(from, to), outer(points.begin(), from);
      inner.push_back(meeting);
      outer.push_back(meeting);
      outer.insert(outer.end(), to, points.end());
      remove_straight(inner);
      remove_straight(outer);
      return area_of(inner) > area_of(outer) ? inner : outer;
    }
  }
  return std::nullopt;
}

}  // namespace

KnifePlane plane_through(const CameraView& view, Vec2 from, Vec2 to) {
  const Pose a = view.ray(from.x, from.y), b = view.ray(to.x, to.y);
  const Vec3 normal = glm::cross(a.direction, b.origin + b.direction - (a.origin + a.direction));
  const double length = glm::length(normal);
  KERF_ASSERT(length > 0);
  return {normal / length, glm::dot(normal, a.origin) / length};
}

bool crosses(const World& world, const KnifePlane& plane) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden) continue;
    bool above = false, below = false;
    for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
      if (!body.mesh.is_live(FaceId(slot))) continue;
      for (const Vec3& p : body.mesh.triangle(FaceId(slot))) {
        const double height = glm::dot(plane.normal, body.placement.to_world(p)) - plane.distance;
        above = above || height > 0;
        below = below || height < 0;
      }
      if (above && below) return true;
    }
  }
  return false;
}

std::vector<Vec2> simplified(std::span<const Vec2> points, double tolerance, bool closed) {
  if (points.size() < 3) return {points.begin(), points.end()};
  std::vector<Vec2> all(points.begin(), points.end());
  if (closed) all.push_back(all.front());
  std::vector<char> kept(all.size(), false);
  size_t middle = all.size() - 1;
  if (closed) {
    const auto distance = [&](const Vec2& p) { return glm::length(p - all.front()); };
    middle = static_cast<size_t>(std::ranges::max_element(all, {}, distance) - all.begin());
  }
  kept.front() = kept[middle] = kept.back() = true;
  keep_between(all, 0, middle, tolerance, kept);
  keep_between(all, middle, all.size() - 1, tolerance, kept);
  std::vector<Vec2> result;
  for (size_t i = 0; i < all.size() - (closed ? 1 : 0); ++i) {
    if (kept[i]) result.push_back(all[i]);
  }
  return result;
}

std::vector<Vec2> largest_loop(std::vector<Vec2> points) {
  remove_straight(points);
  while (auto loop = without_a_loop(points)) points = std::move(*loop);
  return points.size() >= 3 && area_of(points) > 0 ? points : std::vector<Vec2>();
}

bool would_cross(std::span<const Vec2> line, Vec2 to) {
  if (line.size() >= 2) {
    const Vec2 last = line.back() - line[line.size() - 2], next = to - line.back();
    if (cross2(last, next) == 0 && glm::dot(last, next) < 0) return true;
  }
  for (size_t i = 0; i + 2 < line.size(); ++i) {
    if (crossing(line.back(), to, line[i], line[i + 1])) return true;
  }
  return false;
}

KnifePath path_along_view(const CameraView& view, std::span<const Vec2> points, bool closed,
                          const Bounds& bounds) {
  KERF_ASSERT(points.size() >= (closed ? 3u : 2u));
  constexpr double kMargin = 1e-2;
  Interval depth{INFINITY, 0}, distance{0, 0};  // of the corners of the bounds
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
                 corner & 4 ? bounds.max.z : bounds.min.z);
    const double forward = glm::dot(p - view.eye, view.forward);
    depth = {std::min(depth.low, forward), std::max(depth.high, forward)};
    distance.high = std::max(distance.high, glm::length(p - view.eye));
  }
  const double margin = kMargin * bounds.diagonal();
  const double start = view.parallel ? depth.low - margin : 0;
  KnifePath path;
  path.range = {0, (view.parallel ? depth.high - start : distance.high) + margin};
  for (const Vec2& p : points) {
    const Pose ray = view.ray(p.x, p.y);
    path.poses.push_back({ray.origin + start * ray.direction, ray.direction});
  }
  if (closed) path.poses.push_back(path.poses.front());
  return path;
}

}  // namespace kerf
