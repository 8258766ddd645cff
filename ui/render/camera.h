#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "core/base/vec3.h"
#include "core/tree/swept_cylinder.h"
#include "core/world/world.h"

namespace kerf {

// Where the eye stands and how it looks; everything in world coordinates and double. +Y is up in the picture.
struct CameraView {
  Vec3 eye{0, 0, 1};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};  // orthonormal
  double focus = 1;                                     // m, distance of what is looked at
  double tan_half_fov = 0.3;                            // of the vertical field of view
  double aspect = 16.0 / 9;                             // width over height

  // The ray through a point of the picture: x from -1 left to 1 right, y from -1 below to 1 above. Unit
  // direction.
  Pose ray(double x, double y) const;
  // Where a point is seen, and its depth along `forward` (m) as z; x and y mean nothing where z <= 0.
  Vec3 project(const Vec3& p) const;
};

// A view as an eye and a target tell it; a target at the eye or straight above it is taken as near as can be.
CameraView look_at(const Vec3& eye, const Vec3& target, double aspect);

// A turntable: the eye on a sphere around a pivot, never over the poles. Movements set a goal; advance()
// eases the view towards it, nine tenths of the way in 100 ms.
class Camera {
 public:
  // Three-quarter from the front (+Z) and above, the box filling `fill` of the picture's height.
  void frame_default(const World::Bounds& bounds, double aspect, double fill = 0.64);
  // From where it looks now.
  void frame(const World::Bounds& bounds, double aspect, double fill = 0.72);
  void look(const Vec3& eye, const Vec3& target);

  void orbit(double right, double up);  // radians that the eye goes round the pivot
  // Moves what lies at the pivot's depth with a point of the picture; x and y as in CameraView::ray.
  void pan(double dx, double dy, double aspect);
  // The distance times `factor`, with what lies at the pivot's depth under x, y staying there.
  void zoom(double factor, double x, double y, double aspect);

  // Moves on by so many seconds; whether it has still to move.
  bool advance(double seconds);
  void finish() { now_ = goal_; }

  CameraView view(double aspect) const { return view_of(now_, aspect); }
  Vec3 pivot() const { return now_.pivot; }

  static constexpr double kTanHalfFov = 0.3057;  // 34 degrees from top to bottom, more in a narrow picture

 private:
  struct State {
    Vec3 pivot{0};
    double distance = 1;
    double yaw = 0;    // radians from +Z towards +X
    double pitch = 0;  // radians over the horizon
  };
  static CameraView view_of(const State& state, double aspect);
  static void fit(State& state, const World::Bounds& bounds, double aspect, double fill);

  State now_, goal_;
};

}  // namespace kerf
