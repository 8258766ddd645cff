#pragma once

#include <vector>

#include "core/game/vehicle/vehicle.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Adds the bodies of a vehicle to a world, its chassis at a placement, with its joints; the bodies get this
// generation. Appends them to `delta`.
Vehicle add_vehicle(World& world, const std::shared_ptr<const VehicleModel>& model,
                    const Placement& placement, uint32_t generation, Delta& delta);

// The bodies that the chassis carries, and those with the chassis.
std::vector<BodyId> carried_bodies(const Vehicle& vehicle);
std::vector<BodyId> all_bodies(const Vehicle& vehicle);

// Puts the bodies that the chassis carries where it carries them, with the motion that they have there.
void place_carried(World& world, const Vehicle& vehicle);

// The beam that leaves the muzzle, in the world.
Pose muzzle_pose(const World& world, const Vehicle& vehicle);

// A point of the mesh of a vehicle in the world, as if all parts were on it.
Vec3 in_world(const World& world, const Vehicle& vehicle, const Vec3& point);

}  // namespace kerf
