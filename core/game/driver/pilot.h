#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/game/driver/steering.h"

namespace kerf {

struct AimingSkill {
  double error = 0.03;              // rad, standard deviation
  double burst = 1.2, pause = 1.5;  // s, durations of firing and of not firing
  double vital = 0.5;               // fraction of aims at vital parts and the turret
  uint8_t width = 30;               // of the beam (see Controls)
  double range = 24;                // m, maximum distance at which it fires
};

// Aims at a part of an opponent and slashes across it.
class Aiming {
 public:
  Aiming(uint64_t seed, const AimingSkill& skill) : random_(seed), skill_(skill) {}

  // Sets heading, pitch, width and fire. `seen`: the estimated placement of the chassis of the opponent.
  void aim(const DriverView& view, size_t opponent, const Placement& seen, Controls& controls);

 private:
  void select_part(const Vehicle& opponent);
  void wander();
  Vec3 slash(const Vec3& line_of_sight);
  bool pulls_trigger(const DriverView& view, const Pose& wanted, double length);

  Random random_;
  AimingSkill skill_;
  Vec3 part_{0};          // m, in the mesh of the opponent
  int select_in_ = 0;     // ticks until it selects another part
  bool upright_ = false;  // slashes vertically
  double phase_ = 0;      // rad, of the slash
  Vec2 error_{0};         // rad
  int look_in_ = 0;       // ticks until it tests again for a wall in between
  bool walled_ = false;
  int switch_in_ = 0;  // ticks until it fires or pauses
  bool bursting_ = false;
};

struct PilotSkill {
  AimingSkill aiming;
  double reaction = 0.4;  // s, < 2
  double distance = 12;   // m, from its opponent
  double speed = 0.8;     // fraction of the throttle
};

// Drives a vehicle against its opponents: circles around the nearest one, aims at its parts, and retreats
// when damaged. Perceives the placement of its opponent with a delay of its reaction time, and extrapolates
// it with the perceived velocity. Its state is a function of its seed and of the views passed to it.
class Pilot {
 public:
  Pilot(uint64_t seed, const PilotSkill& skill);

  // Returns the controls for the next tick. Call once per tick.
  Controls drive(const DriverView& view);

 private:
  struct Seen {
    Placement placement;
    Vec3 velocity{0};  // m/s
  };
  void select_opponent(const DriverView& view);
  Placement believed(const DriverView& view);
  double distance_to_keep(const Vehicle& own) const;

  PilotSkill skill_;
  Steering steering_;
  Aiming aiming_;
  size_t opponent_ = 0;
  bool has_opponent_ = false;
  int select_in_ = 0;       // ticks until it searches for a nearer opponent
  std::vector<Seen> seen_;  // a ring of the last ticks
  size_t next_ = 0;
  Controls controls_;
};

}  // namespace kerf
