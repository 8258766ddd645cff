#pragma once

#include "core/game/match/match.h"
#include "ui/render/view/camera.h"

namespace kerf {

// The direction in which controls aim in the world, a unit vector.
Vec3 aim_of(const Controls& controls);

// From where the player sees the match.
enum class Viewpoint {
  kRoof,   // over the laser on the roof, along the aim
  kChase,  // behind and above the vehicle
};

// The camera of the player. It follows the vehicle without the jolts of its suspension.
class GameCamera {
 public:
  Viewpoint viewpoint = Viewpoint::kRoof;

  // Lets time pass (s, >= 0). `aim` is the direction in which the player aims, a unit vector. Nothing but
  // arena bodies pushes the camera of the chase view nearer to the vehicle.
  void follow(const Match& match, const Vec3& aim, double seconds);
  // Is where it wants to be at the next follow().
  void cut() { placed_ = false; }
  // Jolts the camera; 1 is a hard crash.
  void shake(double strength);

  // `field_of_view` is vertical, in degrees, from 0 to 180; `aspect` is positive.
  CameraView view(double aspect, double field_of_view) const;
  const Vec3& eye() const { return eye_; }

 private:
  Vec3 wanted_eye(const Match& match, const Vec3& aim) const;

  bool placed_ = false;
  Vec3 eye_{0}, target_{0, 0, 1};
  double height_ = 0;  // m, of the eye, smoothed
  double shake_ = 0, phase_ = 0;
};

}  // namespace kerf
