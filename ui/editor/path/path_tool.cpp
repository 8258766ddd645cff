#include "ui/editor/path/path_tool.h"

#include "ui/editor/path/path_marks.h"
#include "ui/editor/shared/picture/gizmo.h"
#include "ui/editor/shared/surface_point.h"

namespace kerf {

namespace {

constexpr double kLeastDrag = 3;  // screen coordinates; less is a click that chooses

// The normal of the surface at which a point aims, as seen from its origin; against its beam where there is
// none.
Vec3 normal_under(const PathWork& path, const World& world, const ViewState& view, PathPoint point) {
  const Pose& pose = path.pose(point);
  const auto surface = surface_point(world, view.look, pose);
  const bool there = surface && glm::length(surface->at - path.target(point)) < 0.01 * path.distance(point);
  return there ? surface->normal : -pose.direction;
}

}  // namespace

PathTool::Beam PathTool::beam_for(const World& world, double radius) {
  const double diagonal = world.bounds().diagonal();
  if (!(diagonal > 0)) return {.radius = radius};
  return {.radius = radius, .height = diagonal / 16, .speed = diagonal / 4};
}

std::string PathTool::press(PathWork& path, const World& world, const ViewState& view, Vec2 pointer,
                            bool new_stroke, const Beam& beam) {
  const FirstPicture picture(view);
  if (const auto grip = path_grip(path, world, picture, pointer); grip && !new_stroke) {
    path.choose(grip->point);
    take(grip->is_knob ? Grip::kKnob : Grip::kTarget, false, pointer);
    return "";
  }
  const auto surface = surface_point(world, view.look, picture.ray(pointer));
  if (!surface) return "There is no surface under the pointer: points of the path lie on surfaces.";
  const Vec3 direction = beam_direction(-surface->normal);
  path.begin_edit();
  path.add({surface->at - direction * beam.height, direction}, beam.height, new_stroke, beam.radius,
           beam.speed);
  take(Grip::kTarget, true, pointer);
  return "";
}

void PathTool::take(Grip grip, bool edits, Vec2 pointer) {
  grip_ = grip;
  edits_ = edits;
  pressed_at_ = pointer;
}

void PathTool::move(PathWork& path, const World& world, const ViewState& view, Vec2 pointer) {
  if (grip_ == Grip::kNone || !path.chosen()) return;
  if (glm::length(pointer - pressed_at_) < kLeastDrag && !edits_) return;
  if (!edits_) path.begin_edit();
  edits_ = true;
  if (grip_ == Grip::kTarget) {
    drag_target(path, world, view, pointer);
  } else {
    drag_knob(path, view, pointer);
  }
}

void PathTool::drag_target(PathWork& path, const World& world, const ViewState& view, Vec2 pointer) const {
  const PathPoint point = *path.chosen();
  const auto surface = surface_point(world, view.look, FirstPicture(view).ray(pointer));
  if (!surface) return;
  const Vec3 before = normal_under(path, world, view, point);
  const Vec3 direction = beam_direction(turned_with(path.pose(point).direction, before, surface->normal));
  const double distance = path.distance(point);
  path.set(point, {surface->at - direction * distance, direction}, distance);
}

void PathTool::drag_knob(PathWork& path, const ViewState& view, Vec2 pointer) const {
  const FirstPicture picture(view);
  const auto knob = path_knob(path, picture);
  if (!knob) return;
  const PathPoint point = *path.chosen();
  const Vec3 target = path.target(point);
  const Vec3 to = dragged_around(picture, target, knob->distance, knob->at, pointer);
  const Vec3 direction = beam_direction(target - to);
  const double distance = path.distance(point);
  path.set(point, {target - direction * distance, direction}, distance);
}

}  // namespace kerf
