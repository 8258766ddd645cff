#include "ui/editor/section/section_drag.h"

#include <glm/gtc/quaternion.hpp>

#include "core/base/assert.h"
#include "core/base/unit_vector.h"
#include "ui/editor/shared/along_axis.h"

namespace kerf {

namespace {

constexpr double kSmallAngle = 1e-4;  // radians, over which the grip's way in the picture is taken
constexpr double kLeastWay2 = 1e-6;   // of the grip in the picture, for a radian, squared
constexpr double kLeastLevel = 1e-6;  // sine of the angle between the normal and upwards

Vec3 upwards(UpAxis up) { return up == UpAxis::kY ? Vec3(0, 1, 0) : Vec3(0, 0, 1); }

// As wide as high, so that lengths and angles are those on the screen.
Vec2 on_screen(const CameraView& view, const Vec3& seen) { return {seen.x * view.aspect, seen.y}; }

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
  const auto a = along_axis(view_.ray(began_.x, began_.y), from_.point, from_.normal);
  const auto b = along_axis(view_.ray(pointer.x, pointer.y), from_.point, from_.normal);
  return a && b ? SectionPlane{from_.point + from_.normal * (*b - *a), from_.normal} : from_;
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

}  // namespace kerf
