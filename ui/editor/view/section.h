#pragma once

#include "ui/editor/shared/gizmo.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The two perpendicular unit axes in a plane about which it is turned. `level` is horizontal, as far as the
// plane has a unique horizontal direction.
struct PlaneAxes {
  Vec3 level, steep;
};
PlaneAxes axes_of(const SectionPlane& plane, UpAxis up);

// Drag of the section plane along its normal, or about an axis through its point.
class SectionDrag {
 public:
  enum class Kind { kMove, kTilt, kSwing };  // along the normal; about the level axis; about the steep one

  // `pointer`: as in CameraView::ray. `grip`: point of the handle [world] that was grabbed.
  SectionDrag(Kind kind, const SectionPlane& from, const CameraView& view, Vec2 pointer, const Vec3& grip);

  Kind kind() const { return kind_; }
  const SectionPlane& from() const { return from_; }
  // Returns the dragged plane. It is unchanged if it is seen so edge-on that the pointer has no effect.
  SectionPlane to(Vec2 pointer) const;

 private:
  SectionPlane moved(Vec2 pointer) const;
  SectionPlane turned(Vec2 pointer) const;

  Kind kind_;
  SectionPlane from_;
  CameraView view_;
  Vec2 began_;
  Vec3 grip_;
};

// A handle of the section plane, shown while it cuts: an arrow along its normal that moves it, and a half
// ring about each of its axes. Landmarks: "section move", "section tilt", "section swing".
struct SectionHandle : GizmoHandle {
  SectionDrag::Kind kind = SectionDrag::Kind::kMove;
};

// Returns the handles; none if the plane does not cut, or if its point lies behind the eye.
std::vector<SectionHandle> section_handles(const ViewState& view);

// Returns the drag that a press at a place begins, if a handle is there.
std::optional<SectionDrag> section_drag_at(const ViewState& view, Vec2 at);

// Draws the frame of the plane around these bounds of the world, and the handles. `pointer`: its place over
// the viewport; `dragged`: the current drag.
void draw_section(const ViewState& view, const World::Bounds& bounds, std::optional<Vec2> pointer,
                  const std::optional<SectionDrag>& dragged, ImDrawList& list);

}  // namespace kerf
