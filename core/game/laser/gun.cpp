#include "core/game/laser/gun.h"

#include <algorithm>

#include "core/base/angle.h"
#include "core/base/tick.h"

namespace kerf {

namespace {

constexpr double kYawSpeed = 4.5, kPitchSpeed = 3;  // rad/s
constexpr double kLeastEnergy = 0.05;               // to switch the beam on

}  // namespace

void aim(const World& world, Vehicle& vehicle) {
  if (!vehicle.alive || !vehicle.gun.works()) return;
  Gun& gun = vehicle.gun;
  const TurretDescription& turret = vehicle.what().turret;
  const Vec3 wanted = direction_of(vehicle.controls.heading * Controls::kAimStep,
                                   vehicle.controls.pitch * Controls::kAimStep);
  const Vec3 local = glm::conjugate(world.body(vehicle.chassis).placement.orientation) * wanted;
  const double yaw = std::clamp(heading_of(local), turret.yaw.low, turret.yaw.high);
  const bool all_around = turret.yaw.high - turret.yaw.low > 2 * kPi - 1e-3;
  const double way = all_around ? wrapped(yaw - gun.yaw) : yaw - gun.yaw;
  gun.yaw += std::clamp(way, -kYawSpeed * kTick, kYawSpeed * kTick);
  if (all_around) gun.yaw = wrapped(gun.yaw);
  const double pitch = std::clamp(pitch_of(local), turret.barrel.pitch.low, turret.barrel.pitch.high);
  gun.pitch += std::clamp(pitch - gun.pitch, -kPitchSpeed * kTick, kPitchSpeed * kTick);
}

bool trigger(Vehicle& vehicle, double speed, const LaserRules& rules) {
  Gun& gun = vehicle.gun;
  const double width = static_cast<double>(vehicle.controls.width) / Controls::kFull;
  const double least = gun.firing ? 0 : kLeastEnergy;
  gun.firing = vehicle.alive && vehicle.controls.fire && gun.works() && !gun.overheated && gun.energy > least;
  if (!gun.firing) gun.last.reset();
  gun.radius = rules.radius.low + width * (rules.radius.high - rules.radius.low);
  const double effort = gun.firing ? 0.6 + 0.8 * width : 0;
  const double driving = std::min(speed / LaserRules::kDriving, 1.0);
  const double charge = rules.charge + driving * (rules.charge_driving - rules.charge);
  gun.energy += kTick * (gun.firing ? -rules.drain * effort : charge);
  gun.heat += kTick * (gun.firing ? rules.heating * effort : -rules.cooling);
  gun.energy = std::clamp(gun.energy, 0.0, 1.0);
  gun.heat = std::clamp(gun.heat, 0.0, 1.0);
  if (gun.overheated && gun.heat < rules.cooled) gun.overheated = false;
  if (gun.heat < 1 || gun.overheated) return false;
  gun.overheated = true;
  return true;
}

}  // namespace kerf
