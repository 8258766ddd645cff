#pragma once

#include "core/game/match/match.h"
#include "ui/render/view/camera.h"

namespace kerf {

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

}  // namespace kerf
