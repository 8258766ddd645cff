#include "ui/editor/shared/picture/gizmo.h"

#include <imgui.h>

#include <algorithm>

#include "core/base/angle.h"
#include "core/base/assert.h"
#include "core/base/unit_vector.h"
#include "ui/window/imgui_vector.h"

namespace kerf {

namespace {

// How far along a line the point of it is that is nearest to a ray; see dragged_along().
std::optional<double> along_axis(const Pose& ray, const Vec3& at, const Vec3& axis) {
  KERF_ASSERT(is_unit(axis));
  constexpr double kLeastSine2 = 1e-3;  // the square of the sine of the angle between the two
  const double cosine = glm::dot(axis, ray.direction), sine2 = 1 - cosine * cosine;
  if (sine2 < kLeastSine2) return std::nullopt;
  const Vec3 from = ray.origin - at;
  return (glm::dot(from, axis) - cosine * glm::dot(from, ray.direction)) / sine2;
}

}  // namespace

GizmoHandle::GizmoHandle(const FirstPicture& picture, std::string its_name, std::vector<Vec3> its_points,
                         size_t its_grip)
    : name(std::move(its_name)), points(std::move(its_points)), grip(its_grip) {
  KERF_ASSERT(grip < points.size());
  for (const Vec3& p : points) {
    if (const auto at = picture.place_of(p)) places.push_back(*at);
  }
  if (places.size() < points.size()) places.clear();
}

std::vector<Vec3> gizmo_arrow(const FirstPicture& picture, const Vec3& from, const Vec3& direction,
                              double ems) {
  return {from, from + direction * (ems * picture.metres_of_em(from))};
}

// The half in front is one run of points: it begins where the ring comes before its middle.
std::vector<Vec3> gizmo_ring(const FirstPicture& picture, const Vec3& middle, const Vec3& u, const Vec3& v,
                             double ems) {
  const double radius = ems * picture.metres_of_em(middle);
  const Vec3 towards = picture.camera().eye - middle;
  const double front = std::atan2(glm::dot(v, towards), glm::dot(u, towards));
  std::vector<Vec3> points;
  for (size_t k = 0; k < kGizmoRing; ++k) {
    const double angle = front + kPi * (static_cast<double>(k) / (kGizmoRing - 1) - 0.5);
    points.push_back(middle + (u * std::cos(angle) + v * std::sin(angle)) * radius);
  }
  return points;
}

GizmoPoint nearest_point(const GizmoHandle& handle, Vec2 at) {
  const std::vector<Vec2>& places = handle.places;
  GizmoPoint nearest;
  if (places.empty()) return nearest;
  const double length = glm::length(places.back() - places.front());
  if (glm::length(at - places.front()) < handle.free_share * length) return nearest;
  for (size_t i = 0; i < places.size(); ++i) {
    const size_t next = std::min(i + 1, places.size() - 1);
    const Vec2 along = places[next] - places[i];
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(at - places[i], along) / length2, 0.0, 1.0) : 0;
    const double distance = glm::length(at - (places[i] + along * t));
    if (distance >= nearest.distance) continue;
    nearest = {distance, handle.points[i] + (handle.points[next] - handle.points[i]) * t};
  }
  return nearest;
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

double dragged_along(const Pose& from, const Pose& to, const Vec3& at, const Vec3& axis) {
  const auto begin = along_axis(from, at, axis), end = along_axis(to, at, axis);
  return begin && end ? *end - *begin : 0;
}

void draw_handle(const GizmoHandle& handle, double em, uint32_t colour, ImDrawList& list) {
  constexpr ImU32 kRim = IM_COL32(10, 12, 16, 150);
  if (handle.places.empty()) return;
  std::vector<ImVec2> points;
  for (const Vec2& p : handle.places) points.push_back(to_im(p));
  const auto count = static_cast<int>(points.size());
  const bool is_arrow = count == 2;
  list.AddPolyline(points.data(), count, kRim, 0, is_arrow ? 5.0f : 4.0f);
  list.AddPolyline(points.data(), count, colour, 0, is_arrow ? 2.6f : 1.8f);
  if (!is_arrow) return;
  const Vec2 way = handle.places[1] - handle.places[0];
  if (glm::length(way) < 0.5 * em)
    return list.AddCircleFilled(points[1], static_cast<float>(0.3 * em), colour);
  const Vec2 along = glm::normalize(way) * (0.85 * em), across(-0.35 * along.y, 0.35 * along.x);
  const Vec2 tip = handle.places[1] + 0.5 * along;
  list.AddTriangleFilled(to_im(tip), to_im(tip - along + across), to_im(tip - along - across), colour);
}

}  // namespace kerf
