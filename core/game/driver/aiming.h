#pragma once

#include "core/base/random.h"
#include "core/game/driver/driver_view.h"

namespace kerf {

// How well a driver aims and how it fires.
struct AimingSkill {
  double error = 0.03;              // rad, standard deviation
  double burst = 1.2, pause = 1.5;  // s, for which it fires and then does not
  double vital = 0.5;               // the share of aims at vital parts and the turret
  uint8_t width = 30;               // of the beam (see Controls)
  double range = 24;                // m, from which on it does not fire
};

// Aims at a part of an opponent and slashes across it.
class Aiming {
 public:
  Aiming(uint64_t seed, const AimingSkill& skill) : random_(seed), skill_(skill) {}

  // Sets heading, pitch, width and fire. `seen` is where the driver believes the chassis of the opponent to
  // be.
  void aim(const DriverView& view, size_t opponent, const Placement& seen, Controls& controls);

 private:
  void choose_part(const Vehicle& opponent);
  void wander();
  Vec3 slash(const Vec3& line_of_sight);
  bool pulls_trigger(const DriverView& view, const Pose& wanted, double length);

  Random random_;
  AimingSkill skill_;
  Vec3 part_{0};          // m, in the mesh of the opponent
  int choose_in_ = 0;     // ticks until it aims at another part
  bool upright_ = false;  // whether it slashes up and down
  double phase_ = 0;      // rad, of the slash
  Vec2 error_{0};         // rad
  int look_in_ = 0;       // ticks until it looks again whether a wall is between
  bool walled_ = false;
  int switch_in_ = 0;  // ticks until it fires or pauses
  bool bursting_ = false;
};

}  // namespace kerf
