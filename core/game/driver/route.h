#pragma once

#include <span>
#include <vector>

#include "core/game/arena/free_space.h"
#include "core/game/driver/traffic.h"

namespace kerf {

// A way of a vehicle from one place to another, as points a cell apart, or nothing where there is none. It
// stays away from what is fixed as far as there is room, and drives around `traffic` where that is shorter
// than waiting for it. A start without room leads to the nearest spot with room first. The goal is taken to
// the nearest spot with room.
//
// A* (P. Hart, N. Nilsson, B. Raphael: A formal basis for the heuristic determination of minimum cost paths,
// 1968). O(spots log spots) at worst.
std::vector<Vec3> find_route(const FreeSpace& space, std::span<const Disc> traffic, const Vec3& from,
                             const Vec3& to);

}  // namespace kerf
