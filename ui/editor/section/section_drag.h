#pragma once

#include "ui/render/view/camera.h"
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

}  // namespace kerf
