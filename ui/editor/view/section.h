#pragma once

#include "ui/editor/shared/gizmo.h"
#include "ui/render/view/section_plane.h"

namespace kerf {

// The two axes in a plane that it is turned about: the first lies level, as far as a plane has one level
// direction; both are unit vectors and perpendicular to each other.
struct PlaneAxes {
  Vec3 level, steep;
};
PlaneAxes axes_of(const SectionPlane& plane, UpAxis up);

// Moving the section plane along its normal, or turning it about a line through its point, by the pointer.
class SectionDrag {
 public:
  enum class Kind { kMove, kTilt, kSwing };  // along the normal; about the level axis; about the steep one

  // Begins with a place of the pointer, as CameraView::ray takes it. `grip` is the point of the world that
  // the pointer has taken, on the handle.
  SectionDrag(Kind kind, const SectionPlane& from, const CameraView& view, Vec2 pointer, const Vec3& grip);

  Kind kind() const { return kind_; }
  const SectionPlane& from() const { return from_; }
  // The plane where the pointer has it. A plane that is seen from its edge so that the pointer says nothing
  // stays as it was.
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

// Handles of the section plane while it cuts: an arrow along its normal that moves it, and a half ring about
// each of its axes that turns it about its point. Their names: "section move", "section tilt", "section
// swing".
struct SectionHandle : GizmoHandle {
  SectionDrag::Kind kind = SectionDrag::Kind::kMove;
};

// The handles; none where the plane does not cut, or where its point is behind the eye.
std::vector<SectionHandle> section_handles(const ViewState& view);

// What a press of the left button at a place begins, if there is a handle.
std::optional<SectionDrag> section_drag_at(const ViewState& view, Vec2 at);

// Draws the frame of the plane around a world with these bounds, and the handles; `pointer` is where it is
// over the picture, `dragged` what it drags.
void draw_section(const ViewState& view, const World::Bounds& bounds, std::optional<Vec2> pointer,
                  const std::optional<SectionDrag>& dragged, ImDrawList& list);

}  // namespace kerf
