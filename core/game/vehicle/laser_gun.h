#pragma once

#include <functional>
#include <map>

#include "core/base/geometry.h"
#include "core/cut/cut_step.h"
#include "core/game/arena/sight.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// How the lasers of a match work. Shares of energy and heat are of what the laser holds, or bears, at most.
struct LaserRules {
  double range = 40;                   // m
  Interval radius{0.012, 0.035};       // m, of the narrowest and the widest beam
  double drain = 0.16, charge = 0.11;  // 1/s, of energy, while it fires at medium width and while it does not
  double charge_driving = charge;      // 1/s, likewise while the vehicle drives at kDriving or more
  double heating = 0.34, cooling = 0.3;  // 1/s, likewise
  double cooled = 0.35;                  // the heat below which an overheated laser fires again
  static constexpr double kDriving = 8;  // m/s
};

// Turns the turret and the barrel of a vehicle by a tick towards where its controls want them, within their
// limits.
void aim(const World& world, Vehicle& vehicle);

// Switches the beam of a vehicle on or off for a tick as its controls, energy and heat say, and lets energy
// and heat change; `speed` of the vehicle is in m/s. Returns whether it overheated in this tick.
bool trigger(Vehicle& vehicle, double speed, const LaserRules& rules);

inline constexpr size_t kMaxFacesOfTarget = 40'000;

// Where bodies were at the beginning of a tick.
using PlacementsBefore = std::map<BodyId, Placement>;

// Lets the beam of a vehicle, which must be on, cut during a tick: everything between where it was at the end
// of the last tick and where it is, in the frame of each body that it meets, which may have moved meanwhile.
// It ends at the ground and at the first body that is not cuttable, goes through all others, and leaves the
// bodies of its own vehicle alone. No body gets more than kMaxFacesOfTarget faces: a cut that would make
// more ends where it is, with a delta that says that the world is another one. Sets Gun::length and
// Gun::last. `sight` shows the world after the bodies have moved, and `cuttable` tells what the beam cuts.
// Returns what was cut, by body.
std::map<BodyId, StepResult> fire(World& world, Vehicle& vehicle, const Sight& sight,
                                  const std::function<bool(BodyId)>& cuttable, const LaserRules& rules,
                                  const PlacementsBefore& before);

}  // namespace kerf
