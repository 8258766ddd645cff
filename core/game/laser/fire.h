#pragma once

#include <functional>
#include <map>

#include "core/cut/cut_step.h"
#include "core/game/arena/sight.h"
#include "core/game/laser/laser_rules.h"
#include "core/game/vehicle/vehicle.h"

namespace kerf {

inline constexpr size_t kMostFacesOfTarget = 40'000;

// Where bodies were at the beginning of a tick.
using PlacementsBefore = std::map<BodyId, Placement>;

// Lets the beam of a vehicle, which must be on, cut during a tick: everything between where it was at the end
// of the last tick and where it is, in the frame of each body that it meets, which may have moved meanwhile.
// It ends at the ground and at the first body that is not cuttable, goes through all others, and leaves the
// bodies of its own vehicle alone. No body gets more than kMostFacesOfTarget faces: a cut that would make
// more ends where it is, with a delta that says that the world is another one. Sets Gun::length and
// Gun::last. `sight` shows the world after the bodies have moved, and `cuttable` tells what the beam cuts.
// Returns what was cut, by body.
std::map<BodyId, StepResult> fire(World& world, Vehicle& vehicle, const Sight& sight,
                                  const std::function<bool(BodyId)>& cuttable, const LaserRules& rules,
                                  const PlacementsBefore& before);

}  // namespace kerf
