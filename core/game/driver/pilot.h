#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/game/driver/driver_view.h"
#include "core/game/driver/steering.h"

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

struct PilotSkill {
  AimingSkill aiming;
  double reaction = 0.4;  // s, below 2
  double distance = 12;   // m, from its opponent
  double speed = 0.8;     // share of the throttle
};

// Drives a vehicle against its opponents: circles around the nearest one, aims at its parts, and keeps away
// when it is damaged. Sees everything late by its reaction time, and reckons on from there with the velocity
// that it saw. Its state is a function of its seed and of what it was shown.
class Pilot {
 public:
  Pilot(uint64_t seed, const PilotSkill& skill);

  // The controls for the next tick. To be called once a tick.
  Controls drive(const DriverView& view);

 private:
  struct Seen {
    Placement placement;
    Vec3 velocity{0};  // m/s
  };
  void choose_opponent(const DriverView& view);
  Placement believed(const DriverView& view);
  double distance_to_keep(const Vehicle& own) const;

  PilotSkill skill_;
  Steering steering_;
  Aiming aiming_;
  size_t opponent_ = 0;
  bool has_opponent_ = false;
  int choose_in_ = 0;       // ticks until it looks for a nearer opponent
  std::vector<Seen> seen_;  // a ring of the last ticks
  size_t next_ = 0;
  Controls controls_;
};

}  // namespace kerf
