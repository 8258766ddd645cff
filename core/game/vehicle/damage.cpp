#include "core/game/vehicle/damage.h"

#include <algorithm>
#include <vector>

#include "core/base/assert.h"
#include "core/joints/joined_parts.h"

namespace kerf {

namespace {

// The remaining area of the groups of a watch in a body.
class Rest {
 public:
  Rest(const World& world, BodyId id, const FaceWatch& watch)
      : watch_(watch), left_(watch.areas_in(world.body(id))) {}
  bool works(size_t group) const { return left_[group] >= kMinPart * watch_.area(group); }

 private:
  const FaceWatch& watch_;
  std::vector<double> left_;
};

// Returns true if enough of a carried body and of its seat is left.
bool holds(const World& world, BodyId id, const VehicleBody& model) {
  const Rest rest(world, id, model.watch);
  return rest.works(VehicleModel::kAll) && rest.works(VehicleModel::kSeat);
}

void assess_wheels(const World& world, Vehicle& vehicle, const Rest& chassis, Damage& damage) {
  const VehicleModel& model = *vehicle.model;
  for (size_t i = 0; i < vehicle.wheels.size(); ++i) {
    Wheel& wheel = vehicle.wheels[i];
    if (!wheel.attached) continue;
    if (chassis.works(model.wheel_mount(i)) && holds(world, wheel.body, model.wheels[i])) continue;
    wheel.attached = wheel.grounded = false;
    damage.wheels.push_back(i);
  }
}

void assess_gun(const World& world, Vehicle& vehicle, const Rest& chassis, Damage& damage) {
  const VehicleModel& model = *vehicle.model;
  Gun& gun = vehicle.gun;
  if (!gun.turret_attached) return;
  damage.turret = !chassis.works(model.turret_mount()) || !holds(world, gun.turret, model.turret);
  if (gun.barrel_attached) {
    const bool seat = Rest(world, gun.turret, model.turret.watch).works(VehicleModel::kBarrelSeat);
    damage.barrel = damage.turret || !seat || !holds(world, gun.barrel, model.barrel);
  }
  gun.turret_attached = !damage.turret;
  gun.barrel_attached = gun.barrel_attached && !damage.barrel;
  if (!gun.works()) gun.firing = false;
}

void assess_vitals(Vehicle& vehicle, const Rest& chassis, Damage& damage) {
  for (size_t i = 0; i < vehicle.vital_works.size(); ++i) {
    if (!vehicle.vital_works[i] || chassis.works(vehicle.model->vital(i))) continue;
    vehicle.vital_works[i] = false;
    damage.vitals.push_back(i);
  }
}

}  // namespace

double area_of(const Body& body) {
  double area = 0;
  for (uint32_t p = 0; p < body.pieces.size(); ++p) area += body.pieces[p].area;
  return area;
}

Damage assess_damage(const World& world, Vehicle& vehicle) {
  Damage damage;
  const Rest chassis(world, vehicle.chassis, vehicle.model->chassis.watch);
  assess_wheels(world, vehicle, chassis, damage);
  assess_gun(world, vehicle, chassis, damage);
  assess_vitals(vehicle, chassis, damage);
  vehicle.whole = area_of(world.body(vehicle.chassis)) / vehicle.model->chassis_area;
  const bool dead = !damage.vitals.empty() || vehicle.whole < kMinChassis;
  damage.died = vehicle.alive && dead;
  if (dead) vehicle.alive = vehicle.gun.firing = false;
  return damage;
}

bool is_clean(const Body& piece, const Body& loaded) {
  const LoadedComponents& components = loaded.components;
  if (components.of_base.empty()) return false;
  std::vector<double> areas(components.left.size(), 0);
  double all = 0;
  for (uint32_t slot = 0; slot < piece.mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!piece.mesh.is_live(f)) continue;
    const double area = triangle_area(piece.mesh.triangle(f));
    areas[components.of_base[piece.loaded_face(piece.loaded_base(f)).index]] += area;
    all += area;
  }
  if (all < kMinCleanArea) return false;
  for (uint32_t c = 0; c < areas.size(); ++c) {
    if (areas[c] > 0 && areas[c] < kCleanShare * components.left[c].area) return false;
  }
  return true;
}

namespace {

constexpr double kReach = 0.8, kMoreReach = 0.07;  // m at kCrash, and m per m/s above it
constexpr double kMaxReach = 1.6;                  // m

}  // namespace

Vec3 pushed_at(const Body& chassis, const Vec3& change) {
  const Bounds box = chassis.bounds();
  const Vec3 middle = 0.5 * (box.min + box.max), half = 0.5 * (box.max - box.min);
  const Vec3 way = glm::conjugate(chassis.placement.orientation) * -change;
  double share = 1e300;  // of `way`, from the middle to the side
  for (const int axis : {0, 2}) {
    if (way[axis] != 0) share = std::min(share, half[axis] / std::abs(way[axis]));
  }
  if (share == 1e300) share = 0;
  return chassis.placement.to_world(middle + share * Vec3(way.x, 0, way.z));
}

bool release_joints_near(World& world, const Vehicle& vehicle, const Vec3& at, double change) {
  KERF_ASSERT(change >= kCrash);
  KERF_ASSERT(vehicle.model);
  Body& chassis = world.body(vehicle.chassis);
  const Vec3 place = chassis.placement.to_body(at);
  const double reach = std::min(kMaxReach, kReach + kMoreReach * (change - kCrash));
  const std::vector<bool>& breaks = vehicle.model->breaks;
  Joints joints = world.joints();
  size_t own = 0;
  bool any = false;
  for (Joint& joint : joints.all) {
    if (joint.body != chassis.loaded_as) continue;
    KERF_ASSERT(own < breaks.size());
    const bool near = glm::distance(joint.anchor, place) <= reach && !joint.sides[0].faces.empty();
    if (!breaks[own++] || !near) continue;
    joint.sides[0].faces.clear();
    joint.sides[1].faces.clear();
    any = true;
  }
  if (!any) return false;
  world.set_joints(std::move(joints));
  request_joints(world, chassis, {}, true);
  return true;
}

}  // namespace kerf
