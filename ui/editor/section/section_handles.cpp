#include "ui/editor/section/section_handles.h"

#include <imgui.h>

#include <array>
#include <glm/gtc/quaternion.hpp>

#include "core/base/assert.h"
#include "core/base/unit_vector.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kNormalEms = 6.5, kTiltEms = 4.4;  // length and radius
constexpr double kMargin = 1.06;                    // of the frame around the world
constexpr ImU32 kColour = IM_COL32(0xbc, 0xdd, 0xff, 255), kFaint = IM_COL32(0xbc, 0xdd, 0xff, 90);
constexpr ImU32 kDark = IM_COL32(10, 12, 16, 150);

constexpr double kSmallAngle = 1e-4;  // radians, over which the grip's way in the picture is taken
constexpr double kLeastWay2 = 1e-6;   // of the grip in the picture, for a radian, squared
constexpr double kLeastLevel = 1e-6;  // sine of the angle between the normal and upwards

Vec3 upwards(UpAxis up) { return up == UpAxis::kY ? Vec3(0, 1, 0) : Vec3(0, 0, 1); }

// As wide as high, so that lengths and angles are those on the screen.
Vec2 on_screen(const CameraView& view, const Vec3& seen) { return {seen.x * view.aspect, seen.y}; }

// Half of what a box takes up along a unit vector.
double half_size(const World::Bounds& bounds, const Vec3& along) {
  return 0.5 * glm::dot(glm::abs(along), bounds.max - bounds.min);
}

// The rectangle of the plane that the world's box fits in.
void draw_frame(const FirstPicture& picture, const SectionPlane& plane, const World::Bounds& bounds,
                ImDrawList& list) {
  const PlaneAxes axes = axes_of(plane, picture.camera().up_axis);
  const Vec3 box = bounds.min + 0.5 * (bounds.max - bounds.min);
  const Vec3 middle = box - plane.normal * plane.height_of(box);
  const Vec3 u = axes.level * (kMargin * half_size(bounds, axes.level));
  const Vec3 v = axes.steep * (kMargin * half_size(bounds, axes.steep));
  std::array<ImVec2, 4> corners;
  const std::array<Vec3, 4> points{middle - u - v, middle + u - v, middle + u + v, middle - u + v};
  for (size_t i = 0; i < 4; ++i) {
    const auto at = picture.place_of(points[i]);
    if (!at) return;
    corners[i] = to_im(*at);
  }
  list.AddPolyline(corners.data(), 4, kDark, ImDrawFlags_Closed, 2.6f);
  list.AddPolyline(corners.data(), 4, kFaint, ImDrawFlags_Closed, 1.2f);
}

// A half ring around an axis in the plane. The rings of both axes cross in their middles, so that their names
// stand for other points.
SectionHandle ring(const FirstPicture& picture, const SectionPlane& plane, const Vec3& axis, const char* name,
                   SectionDrag::Kind kind) {
  const Vec3 v = glm::cross(axis, plane.normal);
  return {{picture, name, gizmo_ring(picture, plane.point, plane.normal, v, kTiltEms), kGizmoRing / 4}, kind};
}

}  // namespace

PlaneAxes axes_of(const SectionPlane& plane, UpAxis up) {
  KERF_ASSERT(is_unit(plane.normal));
  const Vec3 level = glm::cross(upwards(up), plane.normal);
  const double sine = glm::length(level);
  const Vec3 unit = sine > kLeastLevel ? level / sine : Vec3(1, 0, 0);
  return {unit, glm::normalize(glm::cross(plane.normal, unit))};
}

SectionDrag::SectionDrag(Kind kind, const SectionPlane& from, const CameraView& view, Vec2 pointer,
                         const Vec3& grip)
    : kind_(kind), from_(from), view_(view), began_(pointer), grip_(grip) {}

SectionPlane SectionDrag::to(Vec2 pointer) const {
  return kind_ == Kind::kMove ? moved(pointer) : turned(pointer);
}

SectionPlane SectionDrag::moved(Vec2 pointer) const {
  const double way = dragged_along(view_.ray(began_.x, began_.y), view_.ray(pointer.x, pointer.y),
                                   from_.point, from_.normal);
  return {from_.point + from_.normal * way, from_.normal};
}

// The grip goes along the tangent of its circle: the angle is the share of the pointer's way along the
// tangent as it is seen.
SectionPlane SectionDrag::turned(Vec2 pointer) const {
  const PlaneAxes axes = axes_of(from_, view_.up_axis);
  const Vec3 axis = kind_ == Kind::kTilt ? axes.level : axes.steep;
  const Vec3 tangent = glm::cross(axis, grip_ - from_.point);
  const Vec3 here = view_.project(grip_), there = view_.project(grip_ + tangent * kSmallAngle);
  if (here.z <= 0 || there.z <= 0) return from_;
  const Vec2 way = (on_screen(view_, there) - on_screen(view_, here)) / kSmallAngle;
  const double way2 = glm::dot(way, way);
  if (way2 < kLeastWay2) return from_;
  const Vec2 moved = (pointer - began_) * Vec2(view_.aspect, 1);
  const glm::dquat turn = glm::angleAxis(glm::dot(moved, way) / way2, axis);
  return {from_.point, glm::normalize(turn * from_.normal)};
}

std::vector<SectionHandle> section_handles(const ViewState& view) {
  const SectionPlane* plane = shown_section(view.look);
  const FirstPicture picture(view);
  if (plane == nullptr || !picture.place_of(plane->point)) return {};
  const PlaneAxes axes = axes_of(*plane, picture.camera().up_axis);
  return {ring(picture, *plane, axes.level, "section tilt", SectionDrag::Kind::kTilt),
          ring(picture, *plane, axes.steep, "section swing", SectionDrag::Kind::kSwing),
          {{picture, "section move", gizmo_arrow(picture, plane->point, plane->normal, kNormalEms), 1},
           SectionDrag::Kind::kMove}};
}

std::optional<SectionDrag> section_drag_at(const ViewState& view, Vec2 at) {
  if (!view.layout.first.contains(at)) return std::nullopt;
  const auto handle = handle_under(section_handles(view), at);
  if (!handle) return std::nullopt;
  return SectionDrag(handle->kind, *view.look.section, view.seen_first(), view.in_first(at),
                     nearest_point(*handle, at).point);
}

void draw_section(const ViewState& view, const World::Bounds& bounds, std::optional<Vec2> pointer,
                  const std::optional<SectionDrag>& dragged, ImDrawList& list) {
  const std::vector<SectionHandle> handles = section_handles(view);
  if (handles.empty()) return;
  draw_frame(FirstPicture(view), *view.look.section, bounds, list);
  const auto under = pointer && !dragged ? handle_under(handles, *pointer) : std::nullopt;
  for (const SectionHandle& handle : handles) {
    const bool held = dragged ? dragged->kind() == handle.kind : under && under->kind == handle.kind;
    draw_handle(handle, view.layout.em, held ? colours::accent() : kColour, list);
  }
}

}  // namespace kerf
