#include "core/game/vehicle/vehicle.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"

namespace kerf {

size_t Vehicle::wheels_attached() const {
  return static_cast<size_t>(
      std::count_if(wheels.begin(), wheels.end(), [](const Wheel& w) { return w.attached; }));
}

bool Vehicle::can_drive() const {
  for (size_t i = 0; i < wheels.size(); ++i) {
    if (wheels[i].attached && what().wheels[i].driven) return true;
  }
  return false;
}

bool Vehicle::has(BodyId body) const {
  if (body == chassis) return true;
  if (gun.turret_attached && body == gun.turret) return true;
  if (gun.turret_attached && gun.barrel_attached && body == gun.barrel) return true;
  return std::any_of(wheels.begin(), wheels.end(),
                     [&](const Wheel& w) { return w.attached && w.body == body; });
}

bool Vehicle::is_made_of(const Body& body) const {
  const BodyId id = body.loaded_as;
  return id == chassis || id == gun.turret || id == gun.barrel ||
         std::any_of(wheels.begin(), wheels.end(), [&](const Wheel& w) { return w.body == id; });
}

namespace {

Placement combined(const Placement& outer, const Placement& inner) {
  return {outer.to_world(inner.position), glm::normalize(outer.orientation * inner.orientation)};
}

Placement rotated_about(const Vec3& point, const glm::dquat& turn) { return {point - turn * point, turn}; }

BodyId add(World& world, const VehicleBody& model, const Placement& placement, uint32_t generation,
           Delta& delta) {
  const BodyId id = add_body(world, model, generation);
  world.body(id).placement = placement;
  delta.created.push_back(id);
  return id;
}

Placement wheel_placement(const Vehicle& vehicle, size_t i) {
  const Wheel& wheel = vehicle.wheels[i];
  const Vec3& hub = vehicle.what().wheels[i].hub;
  const glm::dquat turn = axis_angle({0, 1, 0}, wheel.steer) * axis_angle({1, 0, 0}, wheel.angle);
  Placement local = rotated_about(hub, turn);
  local.position.y += wheel.rise;
  return local;
}

Placement turret_placement(const Vehicle& vehicle) {
  return rotated_about(vehicle.what().turret.pivot, axis_angle({0, 1, 0}, vehicle.gun.yaw));
}

Placement barrel_placement(const Vehicle& vehicle) {
  const Vec3& pivot = vehicle.what().turret.barrel.pivot;
  return combined(turret_placement(vehicle), rotated_about(pivot, axis_angle({1, 0, 0}, -vehicle.gun.pitch)));
}

// `spin` [rad/s, in the world]: rotation of the body relative to the chassis, about a point of the world.
void place(World& world, BodyId id, const Body& chassis, const Placement& local, const Vec3& spin,
           const Vec3& about) {
  Body& body = world.body(id);
  body.placement = combined(chassis.placement, local);
  body.motion = chassis.motion;
  body.motion.spin += spin;
  body.motion.velocity = chassis.motion.velocity_at(body.placement.position, chassis.placement) +
                         glm::cross(spin, body.placement.position - about);
}

}  // namespace

Vehicle add_vehicle(World& world, const std::shared_ptr<const VehicleModel>& model,
                    const Placement& placement, uint32_t generation, Delta& delta) {
  Vehicle vehicle;
  vehicle.model = model;
  vehicle.chassis = add(world, model->chassis, placement, generation, delta);
  for (const VehicleBody& wheel : model->wheels)
    vehicle.wheels.emplace_back().body = add(world, wheel, placement, generation, delta);
  vehicle.gun.turret = add(world, model->turret, placement, generation, delta);
  vehicle.gun.barrel = add(world, model->barrel, placement, generation, delta);
  vehicle.vital_works.assign(vehicle.what().vitals.size(), true);
  vehicle.controls.heading =
      static_cast<int32_t>(heading_of(placement.orientation * Vec3(0, 0, 1)) / Controls::kAimStep);
  place_carried(world, vehicle);
  return vehicle;
}

std::vector<BodyId> carried_bodies(const Vehicle& vehicle) {
  std::vector<BodyId> ids;
  for (const Wheel& wheel : vehicle.wheels) {
    if (wheel.attached) ids.push_back(wheel.body);
  }
  if (vehicle.gun.turret_attached) {
    ids.push_back(vehicle.gun.turret);
    if (vehicle.gun.barrel_attached) ids.push_back(vehicle.gun.barrel);
  }
  return ids;
}

std::vector<BodyId> all_bodies(const Vehicle& vehicle) {
  std::vector<BodyId> ids = carried_bodies(vehicle);
  ids.push_back(vehicle.chassis);
  return ids;
}

void place_carried(World& world, const Vehicle& vehicle) {
  const Body& chassis = world.body(vehicle.chassis);
  const Vec3 axis = chassis.placement.orientation * Vec3(1, 0, 0);
  for (size_t i = 0; i < vehicle.wheels.size(); ++i) {
    const Wheel& wheel = vehicle.wheels[i];
    if (!wheel.attached) continue;
    const Vec3 hub = chassis.placement.to_world(vehicle.what().wheels[i].hub + Vec3(0, wheel.rise, 0));
    place(world, wheel.body, chassis, wheel_placement(vehicle, i), wheel.rate * axis, hub);
  }
  const Gun& gun = vehicle.gun;
  if (!gun.turret_attached) return;
  place(world, gun.turret, chassis, turret_placement(vehicle), Vec3(0), Vec3(0));
  if (gun.barrel_attached) place(world, gun.barrel, chassis, barrel_placement(vehicle), Vec3(0), Vec3(0));
}

Pose muzzle_pose(const World& world, const Vehicle& vehicle) {
  KERF_ASSERT(vehicle.gun.works());
  const Placement& placement = world.body(vehicle.gun.barrel).placement;
  return {placement.to_world(vehicle.what().turret.barrel.muzzle),
          glm::normalize(placement.orientation * Vec3(0, 0, 1))};
}

Vec3 in_world(const World& world, const Vehicle& vehicle, const Vec3& point) {
  return world.body(vehicle.chassis).placement.to_world(point);
}

}  // namespace kerf
