#pragma once

#include "core/game/match/match.h"
#include "ui/render/view/camera.h"

namespace kerf {

// The direction in which controls aim in the world, a unit vector.
Vec3 aim_of(const Controls& controls);

// The position of the player's camera.
enum class Viewpoint {
  kRoof,   // over the laser on the roof, along the aim
  kChase,  // behind and above the vehicle
};

// The camera of the player. Smooths out the jolts of the suspension.
class GameCamera {
 public:
  Viewpoint viewpoint = Viewpoint::kRoof;

  // Advances by a time [s], >= 0. `aim` is the direction in which the player aims, a unit vector. Only
  // arena bodies push the chase camera towards the vehicle.
  void follow(const Match& match, const Vec3& aim, double seconds);
  // Skips the smoothing at the next follow().
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

// The camera of a replay: keeps the player's vehicle and another one in the frame from outside, and circles
// slowly around them. Walls, other vehicles and bodies of similar size never occlude the two.
class ReplayCamera {
 public:
  // Films the player's vehicle and `other`, an index of Match::vehicles(), or the player's alone until the
  // other one has spawned. `aside`: offset of the target to the right, as a fraction of its distance, because
  // the result of the match is at the left.
  explicit ReplayCamera(size_t other, double aside = 0.2) : other_(other), aside_(aside) {}

  // Advances by a time [s]. If walls hide the vehicles, moves to the angle with the best view of them.
  void follow(const Match& match, double seconds);
  // `field_of_view` is vertical, in degrees.
  CameraView view(double aspect, double field_of_view) const;
  const Vec3& eye() const { return free_eye_; }

 private:
  struct Aim {
    Vec3 middle;      // m, between the vehicles
    double distance;  // m, from the eye to `middle`
  };
  // The position of the eye around the middle.
  struct EyePosition {
    double angle = 0;      // rad
    double height = 0.34;  // over the middle, as a fraction of the distance
    double nearness = 1;   // factor of the distance
  };
  size_t filmed(const Match& match) const {
    return other_ < match.vehicles().size() ? other_ : Match::kPlayer;
  }
  Aim aim(const Match& match) const;
  static Vec3 eye_at(const Aim& aim, const EyePosition& position);
  // Returns true if a body occludes the vehicles, so that the eye must stay in front of it.
  bool stops(const Match& match, BodyId id) const;
  // Rates the occlusion of the vehicles from a place: 0 if both are visible.
  int hidden_from(const Match& match, const Sight& sight, const Vec3& eye) const;
  Vec3 free_eye(const Match& match, const Sight& sight) const;
  void move_to_best_position(const Match& match, const Sight& sight, const Aim& aim);
  EyePosition best_eye_position(const Match& match, const Sight& sight, const Aim& aim) const;

  size_t other_;
  double aside_;
  bool placed_ = false;
  EyePosition eye_position_;
  double hidden_s_ = 0;  // s, for which a vehicle has been hidden
  Vec3 middle_{0}, eye_{0};
  Vec3 free_eye_{0};  // m, the eye, moved closer to the other vehicle if something is between
};

// The view behind the menu before a match: the player's car from the front, near the ground, at the right
// of the frame; it swings to and fro. `seconds` is the time since it appeared; `field_of_view` is vertical,
// in degrees.
CameraView start_view(const Match& match, double seconds, double aspect, double field_of_view);

}  // namespace kerf
