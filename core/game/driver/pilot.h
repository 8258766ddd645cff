#pragma once

#include <vector>

#include "core/game/driver/aiming.h"
#include "core/game/driver/driver_view.h"
#include "core/game/driver/steering.h"

namespace kerf {

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
