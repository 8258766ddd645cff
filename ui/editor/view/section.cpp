#include "ui/editor/view/section.h"

#include <imgui.h>
#include <array>
#include <glm/gtc/quaternion.hpp>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kNormalEms = 6.5, kTiltEms = 4.4;  // length and radius
constexpr double kFrameMargin = 1.06;               // of the frame around the world
constexpr ImU32 kColour = IM_COL32(0xbc, 0xdd, 0xff, 255), kFaint = IM_COL32(0xbc, 0xdd, 0xff, 90);
constexpr ImU32 kDark = IM_COL32(10, 12, 16, 150);

constexpr double kSmallAngle = 1e-4;  // radians, step of the finite difference of the grip's motion
constexpr double kMinWay2 = 1e-6;     // min. motion of the grip on the screen per radian, squared
constexpr double kMinLevel = 1e-6;    // min. sine of the angle between the normal and the up axis

Vec3 upwards(UpAxis up) { return up == UpAxis::kY ? Vec3(0, 1, 0) : Vec3(0, 0, 1); }

// Scales to equal units in both directions, so that lengths and angles are those on the screen.
Vec2 on_screen(const CameraView& view, const Vec3& seen) { return {seen.x * view.aspect, seen.y}; }

// Returns half the extent of a box along a unit vector.
double half_size(const World::Bounds& bounds, const Vec3& along) {
  return 0.5 * glm::dot(glm::abs(along), bounds.max - bounds.min);
}

// Draws the rectangle in the plane that encloses the bounds of the world.
void draw_frame(const PrimaryViewport& picture, const SectionPlane& plane, const World::Bounds& bounds,
                ImDrawList& list) {
  const PlaneAxes axes = axes_of(plane, picture.camera().up_axis);
  const Vec3 box = bounds.min + 0.5 * (bounds.max - bounds.min);
  const Vec3 middle = box - plane.normal * plane.height_of(box);
  const Vec3 u = axes.level * (kFrameMargin * half_size(bounds, axes.level));
  const Vec3 v = axes.steep * (kFrameMargin * half_size(bounds, axes.steep));
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

// A half ring about an axis in the plane. The rings of both axes cross in their middles, so their landmarks
// are at other points.
SectionHandle ring(const PrimaryViewport& picture, const SectionPlane& plane, const Vec3& axis,
                   const char* name, SectionDrag::Kind kind) {
  const Vec3 v = glm::cross(axis, plane.normal);
  return {{picture, name, gizmo_ring(picture, plane.point, plane.normal, v, kTiltEms), kGizmoRing / 4}, kind};
}

// Edits, by buttons and by name
// --------------------------------------------------------------------------------------------------------

void show(ViewState& view, const SectionPlane& plane) {
  view.look.section = plane;
  view.look.show.section = true;
  view.picture_old = true;
}

// Sets a plane through the centre of the world if the section is enabled but not placed yet.
void place_section(ViewState& view, const World& world) {
  if (!view.look.show.section || view.look.section || world.ids().empty()) return;
  show(view, section_through(world.bounds(), -view.seen_first().forward));
}

void flip_section(ViewState& view) {
  KERF_ASSERT(view.look.section);
  show(view, {view.look.section->point, -view.look.section->normal});
}

// Turn the plane about its point: perpendicular to a world axis (0: X, 1: Y, 2: Z) with the eye on the
// hidden side, or parallel to the screen. Precondition: the plane is placed.
void turn_section_across(ViewState& view, int axis) {
  KERF_ASSERT(view.look.section && axis >= 0 && axis < 3);
  Vec3 normal(0);
  normal[axis] = view.seen_first().forward[axis] > 0 ? -1 : 1;
  show(view, {view.look.section->point, normal});
}

void turn_section_to_view(ViewState& view) {
  KERF_ASSERT(view.look.section);
  show(view, {view.look.section->point, -view.seen_first().forward});
}

// Copies the plane to the clipboard as text, and pastes it; see section_text().
void copy_section(const ViewState& view, Message& message) {
  KERF_ASSERT(view.look.section);
  ImGui::SetClipboardText(section_text(*view.look.section).c_str());
  message.info("Copied the section plane as text for kerf render --section.");
}

void paste_section(ViewState& view, Message& message) {
  const char* text = ImGui::GetClipboardText();
  const Result<SectionPlane> plane = parse_section(text != nullptr ? text : "");
  if (!plane) return message.error("Cannot paste a section plane: " + plane.error().message);
  show(view, *plane);
  message.clear();
}

// The panel
// --------------------------------------------------------------------------------------------------------

bool button(const char* name, const char* landmark, const char* meaning, bool first = false) {
  if (!first) ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  const bool clicked = ImGui::Button(name);
  mark_last_item(landmark);
  tooltip(meaning);
  return clicked;
}

void draw_turns(ViewState& view) {
  property("Align");
  if (button("X", "section X", "Turns the plane perpendicular to the X axis.", true))
    turn_section_across(view, 0);
  if (button("Y", "section Y", "Turns the plane perpendicular to the Y axis.")) turn_section_across(view, 1);
  if (button("Z", "section Z", "Turns the plane perpendicular to the Z axis.")) turn_section_across(view, 2);
  if (button("View", "section view", "Turns the plane parallel to the screen.")) turn_section_to_view(view);
  if (button("Flip", "section flip", "Swaps the visible and the hidden side.")) flip_section(view);
}

void draw_text(ViewState& view, Message& message) {
  property("Plane as Text");
  if (button("Copy", "section copy", "Copies the plane as text for kerf render --section.", true))
    copy_section(view, message);
  if (button("Paste", "section paste", "Sets the plane from the clipboard.")) paste_section(view, message);
}

// The feature
// --------------------------------------------------------------------------------------------------------

class DragOfPlane : public Interaction {
 public:
  DragOfPlane(ViewState& view, const PointerInput& input, SectionDrag drag)
      : view_(view), input_(input), drag_(std::move(drag)) {}

  const SectionDrag& drag() const { return drag_; }
  void move(const InputEvent&) override { show(view_, drag_.to(view_.in_picture(input_.pointer))); }
  bool cancel() override {
    show(view_, drag_.from());
    return true;
  }
  const char* words() const override {
    return drag_.kind() == SectionDrag::Kind::kMove ? "Moving the section plane"
                                                    : "Rotating the section plane";
  }

 private:
  ViewState& view_;
  const PointerInput& input_;
  SectionDrag drag_;
};

using Edit = std::function<void(ViewState&)>;

class SectionFeature : public Feature {
 public:
  SectionFeature(const DocumentSession& session, ViewState& view, const PointerInput& input, Message& message)
      : session_(session), view_(view), input_(input), message_(message) {}

  std::vector<PanelPart> panel_parts() override {
    return {{"view.section", [this] { draw_rows(); }}};
  }

  std::vector<UserAction> actions() override {
    return {
        edit_action("section.flip", "Flip Section Plane", "Swaps the visible and the hidden side.",
                    flip_section),
        across("section.across_x", "Section Plane Across X", 0),
        across("section.across_y", "Section Plane Across Y", 1),
        across("section.across_z", "Section Plane Across Z", 2),
        edit_action("section.face_view", "Align Section Plane to View",
                    "Turns the plane about its point, parallel to the screen.", turn_section_to_view),
        edit_action("section.copy", "Copy Section Plane",
                    "Copies the plane as text for kerf render --section.",
                    [this](ViewState& view) { copy_section(view, message_); }),
        make_action("section.paste", "Paste Section Plane", "", "Sets the plane from text in the clipboard.",
                    [this] { paste_section(view_, message_); })};
  }

  std::vector<Gesture> gestures() const override {
    return {
        {"move_section", "Left drag on the section plane's handles", "Move it along its normal, or turn it"}};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press&) override {
    auto drag = section_drag_at(view_, input_.pointer);
    return drag ? std::make_unique<DragOfPlane>(view_, input_, std::move(*drag)) : nullptr;
  }

  void update(double) override { place_section(view_, session_.world()); }

  void on_document_opened() override {
    view_.look.section.reset();
    view_.look.show.section = false;
  }

  void draw_overlay(ImDrawList& list) override {
    if (is_cutting(input_, session_.document)) return;
    const auto* held = dynamic_cast<const DragOfPlane*>(input_.held.get());
    draw_section(view_, session_.world().bounds(),
                 input_.points() ? std::optional(input_.pointer) : std::nullopt,
                 held != nullptr ? std::optional(held->drag()) : std::nullopt, list);
  }

  void add_landmarks(Landmarks& landmarks) const override { mark_handles(section_handles(view_), landmarks); }

 private:
  // Shows the plane first if it is hidden.
  UserAction edit_action(const char* id, const char* name, const char* tip, Edit edit) {
    UserAction action{.id = id, .name = name, .tip = tip};
    action.run = [this, edit = std::move(edit)] {
      view_.look.show.section = true;
      place_section(view_, session_.world());
      if (view_.look.section) edit(view_);
    };
    return action;
  }
  UserAction across(const char* id, const char* name, int axis) {
    return edit_action(id, name, "Turns the plane about its point and hides the side towards the eye.",
                       [axis](ViewState& view) { turn_section_across(view, axis); });
  }
  // Draws fields for point and normal, in file units, and buttons that flip, turn, copy and paste the plane.
  void draw_rows() {
    if (shown_section(view_.look) == nullptr || !begin_properties("section plane")) return;
    SectionPlane plane = *view_.look.section;
    bool typed = fields_.vector("Section", plane.point, "%.5g", "Point on the plane, about which it turns.",
                                file_unit(view_.frame.unit), session_.world().loaded_bounds().diagonal());
    typed |= fields_.vector("Normal", plane.normal, "%.4g",
                            "Normal of the plane, of any length. The side it points to is hidden.");
    if (typed && plane.normal == Vec3(0)) {
      report_refused_entry("Normal stays the same: one of its numbers must not be 0");
    } else if (typed) {
      view_.look.section = SectionPlane::facing(plane.point, plane.normal);
      view_.picture_old = true;
    }
    draw_turns(view_);
    draw_text(view_, message_);
    end_properties();
  }

  const DocumentSession& session_;
  ViewState& view_;
  const PointerInput& input_;
  Message& message_;
  NumberFields fields_;
};

}  // namespace

PlaneAxes axes_of(const SectionPlane& plane, UpAxis up) {
  KERF_ASSERT(is_unit(plane.normal));
  const Vec3 level = glm::cross(upwards(up), plane.normal);
  const double sine = glm::length(level);
  const Vec3 unit = sine > kMinLevel ? level / sine : Vec3(1, 0, 0);
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

// The grip moves along the tangent of its circle: the angle is the motion of the pointer along the projected
// tangent, relative to that of the grip per radian.
SectionPlane SectionDrag::turned(Vec2 pointer) const {
  const PlaneAxes axes = axes_of(from_, view_.up_axis);
  const Vec3 axis = kind_ == Kind::kTilt ? axes.level : axes.steep;
  const Vec3 tangent = glm::cross(axis, grip_ - from_.point);
  const Vec3 here = view_.project(grip_), there = view_.project(grip_ + tangent * kSmallAngle);
  if (here.z <= 0 || there.z <= 0) return from_;
  const Vec2 way = (on_screen(view_, there) - on_screen(view_, here)) / kSmallAngle;
  const double way2 = glm::dot(way, way);
  if (way2 < kMinWay2) return from_;
  const Vec2 moved = (pointer - began_) * Vec2(view_.aspect, 1);
  const glm::dquat turn = glm::angleAxis(glm::dot(moved, way) / way2, axis);
  return {from_.point, glm::normalize(turn * from_.normal)};
}

std::vector<SectionHandle> section_handles(const ViewState& view) {
  const SectionPlane* plane = shown_section(view.look);
  const PrimaryViewport picture(view);
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
  draw_frame(PrimaryViewport(view), *view.look.section, bounds, list);
  const auto under = pointer && !dragged ? handle_under(handles, *pointer) : std::nullopt;
  for (const SectionHandle& handle : handles) {
    const bool held = dragged ? dragged->kind() == handle.kind : under && under->kind == handle.kind;
    draw_handle(handle, view.layout.em, held ? colours::accent() : kColour, list);
  }
}

std::unique_ptr<Feature> section_feature(Workspace& workspace) {
  return std::make_unique<SectionFeature>(workspace.session, workspace.view, workspace.input,
                                          workspace.message);
}

}  // namespace kerf
