#include "core/game/driver/pilot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "core/game/vehicle/vehicle.h"

namespace kerf {

namespace {

constexpr double kErrorTime = 2.5;   // s, time constant of the aim error
constexpr double kSlashReach = 0.6;  // m
constexpr double kSlashSpeed = 2.5;  // rad/s
constexpr double kOnTarget = 0.12;   // rad, between the actual and the wanted direction of the barrel

int ticks_of(double seconds) { return static_cast<int>(seconds * double{kTicksPerSecond}); }

// Roughly normal, with a standard deviation of 1.
double normal(Random& random) { return 2 * (random.unit() + random.unit() + random.unit() - 1.5); }

}  // namespace

void Aiming::select_part(const Vehicle& opponent) {
  const VehicleModel& model = *opponent.model;
  std::vector<Vec3> vital, other;
  for (size_t i = 0; i < opponent.vital_works.size(); ++i) {
    if (opponent.vital_works[i]) vital.push_back(model.vital_centres[i]);
  }
  if (opponent.gun.turret_attached) vital.push_back(model.description.turret.pivot);
  for (size_t i = 0; i < opponent.wheels.size(); ++i) {
    if (opponent.wheels[i].attached) other.push_back(model.description.wheels[i].hub);
  }
  const bool at_vital = other.empty() ? skill_.vital > 0 : random_.unit() < skill_.vital && !vital.empty();
  const std::vector<Vec3>& parts = at_vital ? vital : other;
  part_ = parts.empty() ? Vec3(0, 0.6, 0) : parts[random_.below(parts.size())];
  upright_ = random_.unit() < 0.5;
  select_in_ = ticks_of(random_.uniform(1.5, 3.5));
}

// The error of aim is an Ornstein-Uhlenbeck process.
void Aiming::wander() {
  const double share = kTick / kErrorTime, size = skill_.error * std::sqrt(2 * share);
  for (int i = 0; i < 2; ++i) error_[i] += size * normal(random_) - share * error_[i];
}

Vec3 Aiming::slash(const Vec3& line_of_sight) {
  phase_ = wrapped(phase_ + kSlashSpeed * kTick);
  const Vec3 up(0, 1, 0), across = glm::cross(up, line_of_sight);
  const double length = glm::length(across);
  return kSlashReach * sin_cos(phase_).sin * (upright_ || !(length > 0.01) ? up : across / length);
}

bool Aiming::pulls_trigger(const DriverView& view, const Pose& wanted, double length) {
  if (--switch_in_ <= 0) {
    bursting_ = !bursting_;
    switch_in_ = std::max(1, ticks_of((bursting_ ? skill_.burst : skill_.pause) * random_.uniform(0.7, 1.3)));
  }
  if (--look_in_ <= 0) {
    look_in_ = kTicksPerSecond / 10;
    const auto hit = view.sight.nearest(wanted, std::max(length - 2, 0.1), view.is_wall);
    walled_ = hit && hit->body.valid();
  }
  if (!bursting_ || walled_ || length > std::min(view.range, skill_.range) || !view.own().gun.works())
    return false;
  return glm::dot(muzzle_pose(view.world, view.own()).direction, wanted.direction) > sin_cos(kOnTarget).cos;
}

void Aiming::aim(const DriverView& view, size_t opponent, const Placement& seen, Controls& controls) {
  if (--select_in_ <= 0) select_part(view.vehicles[opponent]);
  wander();
  const Vec3 from = in_world(view.world, view.own(), view.own().what().turret.barrel.pivot);
  Vec3 way = seen.to_world(part_) - from;
  way += slash(way);
  const double length = std::max(glm::length(way), 0.01);
  const double heading = wrapped(heading_of(way) + error_.x), pitch = pitch_of(way) + error_.y;
  controls.heading = static_cast<int32_t>(heading / Controls::kAimStep);
  controls.pitch = static_cast<int32_t>(pitch / Controls::kAimStep);
  controls.width = skill_.width;
  controls.fire = pulls_trigger(view, {from, direction_of(heading, pitch)}, length);
}

Pilot::Pilot(uint64_t seed, const PilotSkill& skill)
    : skill_(skill), steering_(mix64(seed)), aiming_(mix64(seed + 1), skill.aiming) {
  seen_.reserve(static_cast<size_t>(skill.reaction * kTicksPerSecond) + 1);
}

// Selects the nearest opponent that is alive, with a preference for the current one.
void Pilot::select_opponent(const DriverView& view) {
  const bool lives = has_opponent_ && std::ranges::find(view.opponents, opponent_) != view.opponents.end() &&
                     view.vehicles[opponent_].alive;
  if (lives && --select_in_ > 0) return;
  select_in_ = kTicksPerSecond;
  const size_t before = opponent_;
  double nearest = std::numeric_limits<double>::infinity();
  has_opponent_ = false;
  for (const size_t other : view.opponents) {
    if (!view.vehicles[other].alive) continue;
    const double kept = lives && other == before ? 0.7 : 1;
    const double distance = kept * glm::distance(view.chassis(other).placement.position,
                                                 view.chassis(view.self).placement.position);
    if (distance >= nearest) continue;
    nearest = distance;
    opponent_ = other;
    has_opponent_ = true;
  }
  if (opponent_ != before || !lives) {
    seen_.clear();
    next_ = 0;
  }
}

Placement Pilot::believed(const DriverView& view) {
  const Body& chassis = view.chassis(opponent_);
  const Seen now{chassis.placement, chassis.motion.velocity};
  const size_t late = static_cast<size_t>(skill_.reaction * kTicksPerSecond) + 1;
  if (seen_.size() < late) {
    seen_.push_back(now);
  } else {
    seen_[next_] = now;
    next_ = (next_ + 1) % late;
  }
  const Seen& oldest = seen_[seen_.size() < late ? 0 : next_];
  Placement placement = oldest.placement;
  placement.position += skill_.reaction * oldest.velocity;
  return placement;
}

double Pilot::distance_to_keep(const Vehicle& own) const {
  const bool damaged = own.whole < 0.75 || own.wheels_attached() < own.wheels.size() || !own.gun.works();
  return damaged ? 2 * skill_.distance : skill_.distance;
}

Controls Pilot::drive(const DriverView& view) {
  select_opponent(view);
  if (!has_opponent_) {
    controls_.fire = controls_.handbrake = false;
    controls_.throttle = controls_.steer = 0;
    return controls_;
  }
  const Placement at = believed(view);
  steering_.drive(view, at.position, distance_to_keep(view.own()), skill_.speed, controls_);
  aiming_.aim(view, opponent_, at, controls_);
  return controls_;
}

}  // namespace kerf
