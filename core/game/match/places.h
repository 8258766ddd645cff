#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/game/arena/arena.h"
#include "core/game/arena/free_space.h"
#include "core/game/driver/traffic.h"

namespace kerf {

// The starts of the enemies of an arena for a player at a place (m), those first from which the way to it is
// about 30 m long, so that they come soon and are seen coming. O(starts * spots log spots) at worst.
std::vector<Start> starts_by_way(const ArenaDescription& arena, const FreeSpace& space, const Vec3& player);

// A place for another vehicle, across the view from a vehicle and at most 13 m away, ahead of it where there
// is room and else beside or behind it; nothing where there is none.
std::optional<Placement> place_before(const Placement& vehicle, const FreeSpace& space,
                                      std::span<const Disc> traffic);

}  // namespace kerf
