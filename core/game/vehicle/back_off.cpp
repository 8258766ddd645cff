#include "core/game/vehicle/back_off.h"

#include <algorithm>

#include "core/base/tick.h"

namespace kerf {

namespace {

constexpr double kPatience = 0.9;            // s
constexpr double kFirst = 0.9, kMore = 0.3;  // s, of driving out, and more of it each time
constexpr double kHere = 1, kElsewhere = 6;  // m
constexpr int kMostTimes = 2;                // near the same place
constexpr int kWants = Controls::kFull / 5;  // of the throttle

int direction_of(const Controls& controls) {
  return controls.throttle > kWants ? 1 : controls.throttle < -kWants ? -1 : 0;
}

}  // namespace

Controls backed_off(const World& world, Vehicle& vehicle, const Controls& wanted) {
  BackOff& b = vehicle.back_off;
  const Vec3 here = world.body(vehicle.chassis).placement.position;
  if (!vehicle.alive || !vehicle.can_drive()) return wanted;
  if (b.left_s > 0) {
    b.left_s -= kTick;
    b.held_s = 0;
    Controls out = wanted;
    out.throttle = static_cast<int8_t>(-b.direction * Controls::kFull);
    out.steer = static_cast<int8_t>(b.side * Controls::kFull);
    out.handbrake = false;
    return out;
  }
  const int direction = direction_of(wanted);
  if (direction == 0 || direction != b.direction || glm::distance(here, b.anchor) > kHere) {
    b.direction = direction;
    b.anchor = here;
    b.held_s = 0;
  }
  if (glm::distance(here, b.place) > kElsewhere) b.times = 0;
  if (direction == 0 || wanted.handbrake) return wanted;
  b.held_s += kTick;
  if (b.held_s < kPatience) return wanted;
  b.wedged = b.times == kMostTimes;
  if (b.wedged) return wanted;
  if (b.times == 0) b.place = here;
  b.side = b.times == 0 && wanted.steer != 0 ? (wanted.steer > 0 ? -1 : 1) : -b.side;
  b.left_s = kFirst + kMore * b.times;
  ++b.times;
  return wanted;
}

}  // namespace kerf
