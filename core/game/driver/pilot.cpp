#include "core/game/driver/pilot.h"

#include <algorithm>
#include <limits>

#include "core/base/hash.h"
#include "core/base/tick.h"

namespace kerf {

Pilot::Pilot(uint64_t seed, const PilotSkill& skill)
    : skill_(skill), steering_(mix64(seed)), aiming_(mix64(seed + 1), skill.aiming) {
  seen_.reserve(static_cast<size_t>(skill.reaction * kTicksPerSecond) + 1);
}

// The nearest opponent that is alive, with a preference for the one that it fights already.
void Pilot::choose_opponent(const DriverView& view) {
  const bool lives = has_opponent_ && std::ranges::find(view.opponents, opponent_) != view.opponents.end() &&
                     view.vehicles[opponent_].alive;
  if (lives && --choose_in_ > 0) return;
  choose_in_ = kTicksPerSecond;
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
  choose_opponent(view);
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
