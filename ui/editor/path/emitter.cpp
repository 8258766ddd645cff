#include "ui/editor/path/emitter.h"

#include <imgui.h>

#include "core/base/assert.h"
#include "core/document/files/path_file.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

using Part = EmitterHandle::Part;

constexpr double kArrowEms = 4;
constexpr double kFreeShare = 0.22;      // of an arrow: its start belongs to the body
constexpr float kBody = 7, kTarget = 7;  // radii in screen coordinates
constexpr ImU32 kShade = IM_COL32(10, 12, 16, 150);

Vec3 axis_of(Part part) {
  Vec3 axis(0);
  axis[static_cast<int>(part)] = 1;
  return axis;
}

void draw_body(Vec2 at, bool pointed_at, bool firing, ImDrawList& list) {
  const float radius = pointed_at ? kBody + 1.5f : kBody;
  list.AddCircleFilled(to_im(at), radius + 2, kShade);
  list.AddCircleFilled(to_im(at), radius, IM_COL32(0x1b, 0x1f, 0x26, 255));
  list.AddCircle(to_im(at), radius, firing ? colours::accent() : colours::kPictureText, 0, 2);
  if (firing) list.AddCircleFilled(to_im(at), 3.5f, colours::accent());
}

void draw_target(Vec2 at, bool pointed_at, ImDrawList& list) {
  const float radius = pointed_at ? kTarget + 1.5f : kTarget;
  list.AddCircle(to_im(at), radius, kShade, 0, 4);
  list.AddCircle(to_im(at), radius, colours::kPictureText, 0, 1.6f);
  list.AddCircleFilled(to_im(at), 1.8f, colours::kPictureText);
}

}  // namespace

void Emitter::place(const Vec3& at, const Vec3& target) {
  KERF_ASSERT(at != target);
  placed_ = true;
  at_ = at;
  target_ = target;
}

Pose Emitter::pose() const { return {at_, beam_direction(target_ - at_)}; }

void Emitter::stand_at(const Vec3& at) {
  if (at != target_) at_ = at;
}

void Emitter::aim_at(const Vec3& target) {
  if (target != at_) target_ = target;
}

void Emitter::take(Part part, Vec2 pointer) {
  held_ = part;
  pressed_at_ = pointer;
  held_at_ = at_;
}

// What it aims at stays where it is while the emitter itself is moved.
void Emitter::drag(const FirstPicture& picture, Vec2 pointer, const std::optional<Vec3>& surface) {
  if (held_ == Part::kTarget) return aim_at(surface ? *surface : picture.at_depth_of(target_, pointer));
  Vec3 to = held_at_;
  if (held_ == Part::kBody) {
    to += picture.at_depth_of(held_at_, pointer) - picture.at_depth_of(held_at_, pressed_at_);
  } else {
    const Vec3 axis = axis_of(held_);
    to += axis * dragged_along(picture.ray(pressed_at_), picture.ray(pointer), held_at_, axis);
  }
  stand_at(to);
}

void place_in_view(Emitter& emitter, const CameraView& view, const Vec3& target, double distance) {
  KERF_ASSERT(distance > 0);
  const Vec3 towards = glm::normalize(0.4 * view.right + 0.7 * view.up - 0.6 * view.forward);
  emitter.place(target + towards * distance, target);
}

std::vector<EmitterHandle> emitter_handles(const Emitter& emitter, const FirstPicture& picture) {
  std::vector<EmitterHandle> handles;
  if (!emitter.placed()) return handles;
  handles.push_back({{picture, "emitter target", {emitter.target()}}, Part::kTarget});
  if (!picture.place_of(emitter.at())) return handles;
  constexpr std::array kArrows{"emitter X", "emitter Y", "emitter Z"};
  for (const Part part : {Part::kX, Part::kY, Part::kZ}) {
    handles.push_back({{picture, kArrows.at(static_cast<size_t>(part)),
                        gizmo_arrow(picture, emitter.at(), axis_of(part), kArrowEms), 1},
                       part});
    handles.back().free_share = kFreeShare;
  }
  handles.push_back({{picture, "emitter body", {emitter.at()}}, Part::kBody});
  return handles;
}

void draw_emitter(const Emitter& emitter, const FirstPicture& picture, Vec2 pointer, ImDrawList& list) {
  const std::vector<EmitterHandle> handles = emitter_handles(emitter, picture);
  const auto under = handle_under(handles, pointer);
  const auto at = picture.place_of(emitter.at()), target = picture.place_of(emitter.target());
  if (emitter.placed() && at && target && !emitter.drawing) {
    list.AddLine(to_im(*at), to_im(*target), kShade, 3.4f);
    list.AddLine(to_im(*at), to_im(*target), colours::kPictureSecondary, 1.2f);
  }
  for (const EmitterHandle& handle : handles) {
    const bool pointed_at = under && under->part == handle.part;
    if (handle.part == Part::kTarget) {
      if (target) draw_target(*target, pointed_at, list);
    } else if (handle.part == Part::kBody) {
      draw_body(*at, pointed_at, emitter.firing, list);
    } else {
      draw_handle(handle, picture.em(),
                  pointed_at ? colours::kPictureText : colours::kAxes.at(static_cast<size_t>(handle.part)),
                  list);
    }
  }
}

}  // namespace kerf
