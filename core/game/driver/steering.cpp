#include "core/game/driver/steering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/angle.h"
#include "core/base/tick.h"
#include "core/game/driver/route.h"
#include "core/game/vehicle/drive.h"

namespace kerf {

namespace {

constexpr int kSecond = static_cast<int>(kTicksPerSecond);
constexpr int kLookEvery = 6, kPlanEvery = kSecond;  // ticks
constexpr std::array kSteers{0.0, 0.25, -0.25, 0.55, -0.55, 1.0, -1.0};
constexpr double kCruise = 15, kBack = 4.5;  // m/s
constexpr double kAhead = 9;                 // m, along the route
constexpr double kNear = 3;                  // m, to the end of a route that is done
constexpr double kAway = 0.6;                // m, within which a vehicle is held
constexpr int kHeld = kSecond * 3 / 4;       // ticks, for which it is held before it tries the other way

int8_t share_of_full(double x) { return static_cast<int8_t>(std::clamp(x, -1.0, 1.0) * Controls::kFull); }

double flat_distance(const Vec3& a, const Vec3& b) { return glm::length(Vec2(a.x - b.x, a.z - b.z)); }

Course course_of(const DriverView& view) {
  const Body& chassis = view.chassis(view.self);
  const Vec3 ahead = chassis.placement.orientation * Vec3(0, 0, 1);
  double front = -std::numeric_limits<double>::infinity(), rear = -front;
  for (const WheelDescription& wheel : view.own().what().wheels) {
    front = std::max(front, wheel.hub.z);
    rear = std::min(rear, wheel.hub.z);
  }
  Course course;
  course.heading = heading_of(ahead);
  course.speed = glm::dot(chassis.motion.velocity, ahead);
  course.wheelbase = std::max(front - rear, 1.0);
  course.at = chassis.placement.to_world({0, 0, 0.5 * (front + rear)});
  course.reach = 0.5 * course.wheelbase + 0.1;
  return course;
}

// The traffic but for the vehicle itself.
std::vector<Disc> others_of(const DriverView& view) {
  std::vector<Disc> others(view.traffic.begin(), view.traffic.end());
  std::erase_if(others, [&](const Disc& disc) { return disc.body == view.own().chassis; });
  return others;
}

// Whether a vehicle can drive straight from one place to another.
bool is_straight(const DriverView& view, const Vec3& from, const Vec3& to) {
  const int steps = 1 + static_cast<int>(flat_distance(from, to) / (0.5 * FreeSpace::kCell));
  Vec3 p = from;
  for (int i = 1; i <= steps; ++i) {
    p = Vec3(0, p.y, 0) + (from + (static_cast<double>(i) / steps) * (to - from)) * Vec3(1, 0, 1);
    const FreeSpace::Spot spot = view.space.spot_at(p);
    if (!view.space.has_room(spot)) return false;
    p.y = view.space.place_of(spot).y;
    for (const Disc& disc : view.traffic) {
      const bool waits = disc.body != view.own().chassis && glm::length(disc.velocity) < 1;
      if (waits && flat_distance(disc.centre, p) < disc.radius + 0.9 && std::abs(disc.centre.y - p.y) < 2)
        return false;
    }
  }
  return true;
}

}  // namespace

// Drivers that start together do not look in the same tick, nor plan.
Steering::Steering(uint64_t seed) : random_(seed), side_(random_.unit() < 0.5 ? -1 : 1) {
  look_in_ = 1 + static_cast<int>(random_.below(kLookEvery));
}

Vec3 Steering::choose_goal(const DriverView& view, const Course& course, const Vec3& at,
                           double distance) const {
  const double from = heading_of(course.at - at);
  for (int i = 0; i < 7; ++i) {
    const Vec3 goal = at + distance * direction_of(wrapped(from + side_ * (0.6 + 0.8 * i)), 0);
    const Vec2 room = 0.5 * view.arena_size - Vec2(4);
    if (std::abs(goal.x) > room.x || std::abs(goal.z) > room.y) continue;
    if (view.space.spots() == 0 || view.space.has_room(view.space.spot_at(goal))) return goal;
  }
  return at;
}

// The farthest point of the route to which it can drive straight.
Vec3 Steering::point_ahead(const DriverView& view, const Course& course) const {
  size_t nearest = 0;
  for (size_t i = 1; i < route_.size(); ++i) {
    if (flat_distance(route_[i], course.at) < flat_distance(route_[nearest], course.at)) nearest = i;
  }
  size_t ahead = std::min(nearest + 2, route_.size() - 1);
  for (size_t i = ahead + 1; i < route_.size() && flat_distance(route_[i], course.at) < kAhead; ++i) {
    if (view.space.spots() == 0 || is_straight(view, course.at, route_[i])) ahead = i;
  }
  return route_[ahead];
}

double Steering::value_of(const ArcEnd& end, const Course& course, const Arc& arc, const Vec3& target) const {
  const double progress = flat_distance(course.at, target) - flat_distance(end.at, target);
  const Vec3 way = target - end.at;
  const double off = flat_distance(target, end.at) > 1 ? wrapped(heading_of(way) - end.heading) : 0;
  double value = progress + 2.5 * sin_cos(off).cos + 0.8 * end.room;
  if (end.free_s < kArcTime) value -= 2 + 8 * (1 - end.free_s / kArcTime);
  if (arc.speed < 0) value -= 2.5;
  if (arc.speed * arc_.speed < 0) value -= 1;
  return value;
}

void Steering::choose_arc(const DriverView& view, const Course& course, double share) {
  const Vec3 target =
      route_.empty() ? course.at + 5.0 * direction_of(course.heading, 0) : point_ahead(view, course);
  const std::vector<Disc> others = others_of(view);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double most = -kInfinity;
  Arc best;
  for (const double speed : {share * kCruise, 0.4 * share * kCruise, -kBack}) {
    if (escape_ > 0 && speed * escape_gear_ < 0) continue;
    for (const double steer : kSteers) {
      const Arc arc{steer, speed};
      const ArcEnd end = follow_arc(view.space, others, course, arc);
      const double value = value_of(end, course, arc, target);
      if (value <= most) continue;
      most = value;
      best = arc;
      free_m_ = end.free_s < kArcTime ? end.free_m : kInfinity;
    }
  }
  arc_ = best;
}

// Notices when it does not get away, and then tries the other direction for a while.
void Steering::note_progress(const Course& course, const Controls& controls) {
  if (escape_ > 0) --escape_;
  const bool wants = std::abs(controls.throttle) > Controls::kFull / 5;
  if (flat_distance(course.at, anchor_) > kAway) {
    anchor_ = course.at;
    held_ = 0;
  } else if (wants) {
    ++held_;
  }
  if (held_ < kHeld) return;
  held_ = 0;
  escape_ = kSecond + static_cast<int>(random_.below(kSecond / 2));
  escape_gear_ = controls.throttle > 0 ? -1 : 1;
  side_ = random_.unit() < 0.5 ? side_ : -side_;
  look_in_ = plan_in_ = 0;
}

void Steering::drive(const DriverView& view, const Vec3& at, double distance, double share,
                     Controls& controls) {
  const Course course = course_of(view);
  note_progress(course, controls);
  controls.handbrake = false;
  if (--turn_in_ <= 0) {
    turn_in_ = 3 * kSecond + static_cast<int>(random_.below(6 * kSecond));
    if (random_.unit() < 0.4) side_ = -side_;
  }
  const bool done = route_.empty() || flat_distance(route_.back(), course.at) < kNear;
  if (--plan_in_ <= 0 || (done && plan_in_ < kPlanEvery - kSecond / 4)) {
    plan_in_ = kPlanEvery - static_cast<int>(random_.below(kPlanEvery / 8));
    route_ = find_route(view.space, others_of(view), course.at, choose_goal(view, course, at, distance));
  }
  if (--look_in_ <= 0) {
    look_in_ = kLookEvery;
    choose_arc(view, course, share);
  }
  controls.steer = share_of_full(arc_.steer);
  const double safe = std::sqrt(2 * 5.0 * std::max(free_m_ - 0.5, 0.1));  // m/s, to stop in time
  const double wanted = std::clamp(arc_.speed, -safe, safe);
  controls.throttle = share_of_full(0.6 * (wanted - course.speed) + (wanted > 0 ? 0.1 : -0.1));
}

}  // namespace kerf
