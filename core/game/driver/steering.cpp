#include "core/game/driver/steering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/tick.h"
#include "core/game/angle.h"
#include "core/game/vehicle/drive.h"

namespace kerf {

namespace {

constexpr int kSecond = static_cast<int>(kTicksPerSecond);
constexpr int kLookEvery = 6;                                                        // ticks
constexpr std::array kOffsets{0.0, 0.3, -0.3, 0.6, -0.6, 0.95, -0.95, 1.35, -1.35};  // rad
constexpr double kEyeHeight = 0.13, kHalfWidth = 0.9;                                // m, of rays ahead
constexpr int kDetour = 2 * kSecond;                                                 // ticks
constexpr double kMargin = 3;  // m, to the edge of the arena

// How far it is from p along a direction to the edge of the arena, less a margin.
double to_edge(const Vec3& p, const Vec3& direction, const Vec2& size) {
  double length = std::numeric_limits<double>::infinity();
  const auto along = [&](double at, double way, double half) {
    if (way != 0) length = std::min(length, ((way > 0 ? half - kMargin : kMargin - half) - at) / way);
  };
  along(p.x, direction.x, 0.5 * size.x);
  along(p.z, direction.z, 0.5 * size.y);
  return std::max(0.0, length);
}

int8_t share_of_full(double x) { return static_cast<int8_t>(std::clamp(x, -1.0, 1.0) * Controls::kFull); }

}  // namespace

double Steering::wanted_heading(const DriverView& view, const Vec3& at, double distance) {
  const Vec3 way = at - view.chassis(view.self).placement.position;
  const double length = std::max(glm::length(Vec2(way.x, way.z)), 0.1);
  const double off = std::clamp((length - distance) / distance, -1.0, 1.0);
  // Far away straight on, near straight back, and across the line of sight at the right distance.
  return heading_of(way) + side_ * (kPi / 2) * (1 - off);
}

double Steering::clear_length(const DriverView& view, double heading, double length) const {
  const Vehicle& own = view.own();
  const Body& chassis = view.chassis(view.self);
  const Vec3 direction = direction_of(heading, 0), across(direction.z, 0, -direction.x);
  const Vec3 middle = chassis.placement.to_world({0, kEyeHeight, 0});
  double clear = std::min(length, to_edge(middle, direction, view.arena_size));
  for (const double side : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const Pose ray{middle + side * kHalfWidth * across, direction};
    const auto hit = view.sight.nearest(ray, clear, [&](BodyId id) { return !own.has(id); });
    const bool slope = hit && hit->normal.y > 0.7;
    if (hit && !slope) clear = hit->length;
  }
  return clear;
}

double Steering::choose_heading(const DriverView& view, double wanted, double reach) {
  const double own = heading_of(view.chassis(view.self).placement.orientation * Vec3(0, 0, 1));
  double best = own, most = -std::numeric_limits<double>::infinity();
  for (const double offset : kOffsets) {
    const double heading = own + offset, clear = clear_length(view, heading, reach);
    const double score = 2.5 * std::min(clear / reach, 1.0) + sin_cos(wrapped(heading - wanted)).cos;
    if (score <= most) continue;
    most = score;
    best = heading;
    clear_ = clear;
  }
  return best;
}

// Returns whether it drives backwards.
bool Steering::back_out(double speed, Controls& controls) {
  if (reverse_ == 0) {
    blocked_ = std::abs(speed) < 0.5 ? blocked_ + 1 : 0;
    if (blocked_ < kSecond) return false;
    blocked_ = 0;
    reverse_ = kSecond + static_cast<int>(random_.below(kSecond));
    side_ = -side_;
  }
  --reverse_;
  look_in_ = 0;
  detour_ = kDetour;
  controls.throttle = -80;
  controls.steer = static_cast<int8_t>(side_ > 0 ? -70 : 70);
  return true;
}

void Steering::drive(const DriverView& view, const Vec3& at, double distance, double share,
                     Controls& controls) {
  const Body& chassis = view.chassis(view.self);
  const Vec3 ahead = chassis.placement.orientation * Vec3(0, 0, 1);
  const double speed = glm::dot(chassis.motion.velocity, ahead);
  controls.handbrake = false;
  if (--turn_in_ <= 0) {
    turn_in_ = 3 * kSecond + static_cast<int>(random_.below(6 * kSecond));
    if (random_.unit() < 0.4) side_ = -side_;
  }
  if (back_out(speed, controls)) return;
  if (detour_ > 0) --detour_;
  if (--look_in_ <= 0) {
    look_in_ = kLookEvery;
    const double aside = detour_ > 0 ? 1.2 * side_ : 0;
    const double wanted = wanted_heading(view, at, distance) + aside;
    heading_ = choose_heading(view, wanted, 7 + 1.1 * std::abs(speed));
  }
  const double off = wrapped(heading_ - heading_of(ahead));
  controls.steer = share_of_full(off / full_lock(std::abs(speed)));
  const double safe = std::sqrt(2 * 5.0 * std::max(clear_ - 2.5, 0.3));  // m/s, to stop in front of a wall
  const double slow_in_turns = std::max(0.35, 1 - 0.5 * std::abs(off));
  controls.throttle = share_of_full(speed > safe ? -0.7 : share * slow_in_turns);
}

}  // namespace kerf
