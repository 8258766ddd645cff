#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/game/arena/arena.h"
#include "core/game/arena/free_space.h"
#include "core/game/driver/driver_view.h"
#include "core/game/match/rules.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// The starts of the enemies of an arena for a player at a place (m), those first from which the way to it is
// about 30 m long, so that they come soon and are seen coming. O(starts * spots log spots) at worst.
std::vector<Start> starts_by_way(const ArenaDescription& arena, const FreeSpace& space, const Vec3& player);

// A place for another vehicle, across the view from a vehicle and at most 13 m away, ahead of it where there
// is room and else beside or behind it; nothing where there is none.
std::optional<Placement> place_before(const Placement& vehicle, const FreeSpace& space,
                                      std::span<const Disc> traffic);

// Counts for how long a vehicle lies on its side or roof, and for how long it has not got away from a place
// although it wants to or lies there, and helps it after a while if it is alive and has a wheel. One that
// lies is put upright where it is, a little higher; one that is stuck, or does not get away after that, goes
// to where it last drove freely, or else to the nearest place in `space` with room, and one that is wedged
// (see backed_off) at once to such a place. Returns whether it did. To be called once a tick.
bool recover_vehicle(World& world, Vehicle& vehicle, const FreeSpace& space, const MatchTimes& times);

// A placement with the heading of another one, upright and a little above it, not below the ground (m).
Placement upright(const Placement& placement, double ground);

}  // namespace kerf
