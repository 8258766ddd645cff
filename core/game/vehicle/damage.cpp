#include "core/game/vehicle/damage.h"

namespace kerf {

namespace {

// What is left of the groups of a watch in a body.
class Rest {
 public:
  Rest(const World& world, BodyId id, const FaceWatch& watch)
      : watch_(watch), left_(watch.areas_in(world.body(id))) {}
  bool works(size_t group) const { return left_[group] >= kLeastPart * watch_.area(group); }

 private:
  const FaceWatch& watch_;
  std::vector<double> left_;
};

// Whether a carried body holds together from its seat on.
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
  const bool dead = !damage.vitals.empty() || vehicle.whole < kLeastChassis;
  damage.died = vehicle.alive && dead;
  if (dead) vehicle.alive = vehicle.gun.firing = false;
  return damage;
}

}  // namespace kerf
