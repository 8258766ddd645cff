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

// The camera of a replay: it stands outside, keeps the player's vehicle and another one in the picture, and
// circles slowly around them. It stays on this side of walls, of other vehicles, and of what is as large.
class ReplayCamera {
 public:
  // Watches the player's vehicle and `other`, an index of Match::vehicles(). What it looks at is right of the
  // middle of the picture by `aside`, a share of its distance: the result of the match stands at the left.
  explicit ReplayCamera(size_t other, double aside = 0.2) : other_(other), aside_(aside) {}

  // Lets time pass (s). Where walls hide the vehicles it goes to where it sees them best.
  void follow(const Match& match, double seconds);
  // `field_of_view` is vertical, in degrees.
  CameraView view(double aspect, double field_of_view) const;
  const Vec3& eye() const { return free_eye_; }

 private:
  struct Aim {
    Vec3 middle;      // m, between the vehicles
    double distance;  // m, of the eye from there
  };
  // Where the eye stands around the middle.
  struct Stand {
    double angle = 0;      // rad
    double height = 0.34;  // over the middle, a share of the distance
    double nearness = 1;   // a share of the distance
  };
  Aim aim(const Match& match) const;
  static Vec3 eye_at(const Aim& aim, const Stand& stand);
  // Whether a body hides what is behind it, and the eye stays before it.
  bool stops(const Match& match, BodyId id) const;
  // How badly a place sees the vehicles: 0 if it sees both.
  int hidden_from(const Match& match, const Sight& sight, const Vec3& eye) const;
  Vec3 free_eye(const Match& match, const Sight& sight) const;
  void stand_at_best(const Match& match, const Sight& sight, const Aim& aim);
  Stand best_stand(const Match& match, const Sight& sight, const Aim& aim) const;

  size_t other_;
  double aside_;
  bool placed_ = false;
  Stand stand_;
  double hidden_s_ = 0;  // for how long a vehicle has been hidden
  Vec3 middle_{0}, eye_{0};
  Vec3 free_eye_{0};  // m, the eye, or nearer to the vehicle to which it happens where something is between
};

// The view behind the menu before a match: the player's car from ahead, near the ground, at the right of the
// picture; it swings to and fro. `seconds` is for how long it is shown, `field_of_view` is vertical, in
// degrees.
CameraView start_view(const Match& match, double seconds, double aspect, double field_of_view);

}  // namespace kerf
