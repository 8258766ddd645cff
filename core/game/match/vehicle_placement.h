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

// Sorts the enemy starts of an arena for a player at a place [m]: first those with a route of about 30 m to
// it, so that enemies arrive soon and can be seen arriving. O(starts * spots log spots) in the worst case.
std::vector<Start> starts_by_way(const ArenaDescription& arena, const FreeSpace& space, const Vec3& player);

// A place for another vehicle, across the view from a vehicle and at most 13 m away, ahead of it if there
// is room, else at its side or behind it; nullopt if there is none.
std::optional<Placement> place_before(const Placement& vehicle, const FreeSpace& space,
                                      std::span<const Disc> traffic);

// Measures how long a vehicle lies on its side or roof, and how long it makes no progress although it tries
// to or lies there, and recovers it after a while if it is alive and has a wheel. A lying vehicle is put
// upright in place, a little higher. A stuck one, or one that makes no progress after that, is moved to
// where it last drove freely, or else to the nearest place in `space` with room; a wedged one (see
// backed_off) is moved there immediately. Returns true if it recovered the vehicle. Call once per tick.
bool recover_vehicle(World& world, Vehicle& vehicle, const FreeSpace& space, const MatchTimes& times);

// A placement with the heading of another one, upright and a little above it, not below the ground [m].
Placement upright(const Placement& placement, double ground);

}  // namespace kerf
