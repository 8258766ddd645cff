#include "ui/editor/section/section_handles.h"

#include <imgui.h>

#include <array>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/assert.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kNormalEms = 6.5, kTiltEms = 4.4;  // length and radius
constexpr double kReachOfHandle = 7;                // screen coordinates around a handle that belong to it
constexpr size_t kTiltPoints = 48;
constexpr double kMargin = 1.06;  // of the frame around the world
constexpr ImU32 kColour = IM_COL32(0xbc, 0xdd, 0xff, 255), kFaint = IM_COL32(0xbc, 0xdd, 0xff, 90);
constexpr ImU32 kDark = IM_COL32(10, 12, 16, 150);

// A point of the world in the window; nothing behind the eye.
std::optional<Vec2> place_of(const CameraView& camera, const Area& area, const Vec3& p) {
  const Vec3 seen = camera.project(p);
  if (seen.z <= 0) return std::nullopt;
  return area.at + Vec2(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y) * area.size;
}

// m of the world at the depth of a point that are as long as the text is high.
double em_at(const ViewState& view, const CameraView& camera, const Vec3& p) {
  return 2 * camera.project(p).z * camera.tan_half_fov / view.layout.first.size.y * view.layout.em;
}

std::vector<Vec3> arrow_of(const SectionPlane& plane, double em) {
  return {plane.point, plane.point + plane.normal * (kNormalEms * em)};
}

// The half in front, one run of points.
std::vector<Vec3> ring_of(const SectionPlane& plane, const Vec3& axis, const Vec3& eye, double em) {
  const Vec3 u = plane.normal * (kTiltEms * em), v = glm::cross(axis, plane.normal) * (kTiltEms * em);
  const Vec3 towards = glm::normalize(eye - plane.point);
  const double middle = std::atan2(glm::dot(v, towards), glm::dot(u, towards));
  std::vector<Vec3> points;
  for (size_t k = 0; k <= kTiltPoints; ++k) {
    const double angle = middle + kPi * (static_cast<double>(k) / kTiltPoints - 0.5);
    points.push_back(plane.point + u * std::cos(angle) + v * std::sin(angle));
  }
  return points;
}

// The point of a handle that is seen nearest to a place, and how far from it.
struct Nearest {
  double distance = INFINITY;
  Vec3 point{0};
};
Nearest nearest_of(const SectionHandle& handle, Vec2 at) {
  KERF_ASSERT(handle.places.size() == handle.points.size());
  Nearest nearest;
  for (size_t i = 0; i + 1 < handle.places.size(); ++i) {
    const Vec2 a = handle.places[i], along = handle.places[i + 1] - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(at - a, along) / length2, 0.0, 1.0) : 0;
    const double distance = glm::length(at - (a + along * t));
    if (distance >= nearest.distance) continue;
    nearest = {distance, handle.points[i] + (handle.points[i + 1] - handle.points[i]) * t};
  }
  return nearest;
}

struct Grip {
  SectionDrag::Kind kind;
  Vec3 point;
};
std::optional<Grip> grip_under(const std::vector<SectionHandle>& handles, Vec2 at) {
  std::optional<Grip> found;
  double least = kReachOfHandle;
  for (const SectionHandle& handle : handles) {
    const Nearest nearest = nearest_of(handle, at);
    if (nearest.distance > least) continue;
    least = nearest.distance;
    found = Grip{handle.kind, nearest.point};
  }
  return found;
}

void draw_handle(const SectionHandle& handle, double em, ImU32 colour, ImDrawList& list) {
  std::vector<ImVec2> points;
  for (const Vec2& p : handle.places) points.push_back(to_im(p));
  const auto count = static_cast<int>(points.size());
  const bool is_arrow = handle.kind == SectionDrag::Kind::kMove;
  list.AddPolyline(points.data(), count, kDark, 0, is_arrow ? 5.0f : 4.0f);
  list.AddPolyline(points.data(), count, colour, 0, is_arrow ? 2.6f : 1.8f);
  if (!is_arrow) return;
  const Vec2 way = handle.places[1] - handle.places[0];
  if (glm::length(way) < 0.5 * em)
    return list.AddCircleFilled(points[1], static_cast<float>(0.3 * em), colour);
  const Vec2 along = glm::normalize(way) * (0.85 * em), across(-0.35 * along.y, 0.35 * along.x);
  const Vec2 tip = handle.places[1] + 0.5 * along;
  list.AddTriangleFilled(to_im(tip), to_im(tip - along + across), to_im(tip - along - across), colour);
}

// Half of what a box takes up along a unit vector.
double half_size(const World::Bounds& bounds, const Vec3& along) {
  return 0.5 * glm::dot(glm::abs(along), bounds.max - bounds.min);
}

// The rectangle of the plane that the world's box fits in.
void draw_frame(const ViewState& view, const CameraView& camera, const SectionPlane& plane,
                const World::Bounds& bounds, ImDrawList& list) {
  const PlaneAxes axes = axes_of(plane, camera.up_axis);
  const Vec3 box = bounds.min + 0.5 * (bounds.max - bounds.min);
  const Vec3 middle = box - plane.normal * plane.height_of(box);
  const Vec3 u = axes.level * (kMargin * half_size(bounds, axes.level));
  const Vec3 v = axes.steep * (kMargin * half_size(bounds, axes.steep));
  std::array<ImVec2, 4> corners;
  const std::array<Vec3, 4> points{middle - u - v, middle + u - v, middle + u + v, middle - u + v};
  for (size_t i = 0; i < 4; ++i) {
    const auto at = place_of(camera, view.layout.first, points[i]);
    if (!at) return;
    corners[i] = to_im(*at);
  }
  list.AddPolyline(corners.data(), 4, kDark, ImDrawFlags_Closed, 2.6f);
  list.AddPolyline(corners.data(), 4, kFaint, ImDrawFlags_Closed, 1.2f);
}

}  // namespace

std::vector<SectionHandle> section_handles(const ViewState& view) {
  const SectionPlane* plane = shown_section(view.look);
  if (plane == nullptr) return {};
  const CameraView camera = view.seen_first();
  if (camera.project(plane->point).z <= 0) return {};
  const double em = em_at(view, camera, plane->point);
  const PlaneAxes axes = axes_of(*plane, camera.up_axis);
  std::vector<SectionHandle> handles{
      {SectionDrag::Kind::kTilt, ring_of(*plane, axes.level, camera.eye, em), {}},
      {SectionDrag::Kind::kSwing, ring_of(*plane, axes.steep, camera.eye, em), {}},
      {SectionDrag::Kind::kMove, arrow_of(*plane, em), {}}};
  for (SectionHandle& handle : handles) {
    for (const Vec3& p : handle.points) {
      const auto at = place_of(camera, view.layout.first, p);
      if (!at) return {};
      handle.places.push_back(*at);
    }
  }
  return handles;
}

std::optional<SectionDrag> section_drag_at(const ViewState& view, Vec2 at) {
  if (!view.layout.first.contains(at)) return std::nullopt;
  const auto grip = grip_under(section_handles(view), at);
  if (!grip) return std::nullopt;
  return SectionDrag(grip->kind, *view.look.section, view.seen_first(), view.in_first(at), grip->point);
}

std::string name_of(const SectionHandle& handle) {
  constexpr std::array kNames{"section move", "section tilt", "section swing"};
  return kNames.at(static_cast<size_t>(handle.kind));
}

Vec2 grip_of(const SectionHandle& handle) {
  KERF_ASSERT(!handle.places.empty());
  const bool is_arrow = handle.kind == SectionDrag::Kind::kMove;
  return is_arrow ? handle.places.back() : handle.places[handle.places.size() / 4];
}

void draw_section(const ViewState& view, const World::Bounds& bounds, std::optional<Vec2> pointer,
                  const std::optional<SectionDrag>& dragged, ImDrawList& list) {
  const std::vector<SectionHandle> handles = section_handles(view);
  if (handles.empty()) return;
  draw_frame(view, view.seen_first(), *view.look.section, bounds, list);
  const auto under = pointer && !dragged ? grip_under(handles, *pointer) : std::nullopt;
  for (const SectionHandle& handle : handles) {
    const bool held = dragged ? dragged->kind() == handle.kind : under && under->kind == handle.kind;
    draw_handle(handle, view.layout.em, held ? colours::accent() : kColour, list);
  }
}

}  // namespace kerf
