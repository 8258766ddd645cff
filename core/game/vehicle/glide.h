#pragma once

#include "core/game/arena/obstacles.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// Whether a vehicle stands upright enough for its wheels to carry it. The physics then leaves what stands
// fast to glide_along, since the many rims of a chassis would get caught on it.
bool is_upright(const World& world, const Vehicle& vehicle);

// Pushes a vehicle out of the steep faces of the arena, sideways: balls along the sides of the vehicle lose
// their velocity against what they touch, with little friction, so that it slides along walls and around
// columns. Wheels and slopes are left to drive().
void glide_along(World& world, const Vehicle& vehicle, const Obstacles& obstacles);

}  // namespace kerf
