#pragma once

#include <functional>
#include <map>

#include "core/base/geometry.h"
#include "core/cut/cut_step.h"
#include "core/game/arena/sight.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// Parameters of the lasers of a match. Energy and heat are fractions of their maximum.
struct LaserRules {
  double range = 40;                   // m
  Interval radius{0.012, 0.035};       // m, of the narrowest and the widest beam
  double drain = 0.16, charge = 0.11;  // 1/s, of energy, while it fires at medium width and while it does not
  double charge_driving = charge;      // 1/s, likewise while the vehicle drives at kDriving or more
  double heating = 0.34, cooling = 0.3;  // 1/s, likewise
  double cooled = 0.35;                  // heat below which an overheated laser fires again
  static constexpr double kDriving = 8;  // m/s
};

// Turns the turret and the barrel of a vehicle for a tick towards the aim of its controls, within their
// limits.
void aim(const World& world, Vehicle& vehicle);

// Switches the beam of a vehicle on or off for a tick according to its controls, energy and heat, and
// updates energy and heat; `speed` of the vehicle [m/s]. Returns true if it overheated in this tick.
bool trigger(Vehicle& vehicle, double speed, const LaserRules& rules);

inline constexpr size_t kMaxFacesOfTarget = 40'000;

// Placements of bodies at the start of a tick.
using PlacementsBefore = std::map<BodyId, Placement>;

// Cuts with the beam of a vehicle for a tick: the volume swept from the pose at the end of the last tick to
// the current one, in the frame of each body that it hits, which may have moved in the meantime. The beam
// ends at the ground and at the first body that is not cuttable, passes through all others, and ignores the
// bodies of its own vehicle. A cut that would give a body more than kMaxFacesOfTarget faces ends early,
// with a delta that requires a complete reload. Sets Gun::length and Gun::last. `sight`: the world after
// the bodies have moved; `cuttable`: returns true if the beam cuts a body. Returns the cuts by body.
// Precondition: the beam is on.
std::map<BodyId, StepResult> fire(World& world, Vehicle& vehicle, const Sight& sight,
                                  const std::function<bool(BodyId)>& cuttable, const LaserRules& rules,
                                  const PlacementsBefore& before);

}  // namespace kerf
