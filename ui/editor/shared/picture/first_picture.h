#pragma once

#include <optional>

#include "ui/editor/shared/picture/view_state.h"

namespace kerf {

// The first half of the picture, which shows the open document, with its camera: where points of the world
// are in the window (screen coordinates), and which rays belong to places of the window.
class FirstPicture {
 public:
  explicit FirstPicture(const ViewState& view)
      : camera_(view.seen_first()), area_(view.layout.first), em_(view.layout.em) {}

  const CameraView& camera() const { return camera_; }
  double em() const { return em_; }  // the size of the text

  // The place of a point of the world; nothing behind the eye.
  std::optional<Vec2> place_of(const Vec3& p) const;
  // The length (m) that is as long as the text is high, at the depth of a point in front of the eye.
  double metres_of_em(const Vec3& p) const;
  // The ray through a place. Its direction is a unit vector.
  Pose ray(Vec2 place) const;
  // The point on that ray at the depth of a point of the world.
  Vec3 at_depth_of(const Vec3& p, Vec2 place) const;

 private:
  CameraView camera_;
  Area area_;
  double em_;
};

}  // namespace kerf
