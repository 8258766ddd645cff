#include "core/game/driver/steering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/game/vehicle/vehicle_dynamics.h"

namespace kerf {

namespace {

constexpr double kSmall = 0.8;      // m, diagonal of bodies that vehicles drive over
constexpr double kFlat = 0.25;      // m, their height
constexpr double kTall = 3.5;       // m, height above which bodies over a vehicle are ignored
constexpr double kUnderRoof = 2.2;  // m

bool is_carried(std::span<const Vehicle> vehicles, BodyId id) {
  return std::any_of(vehicles.begin(), vehicles.end(),
                     [&](const Vehicle& v) { return v.chassis != id && v.has(id); });
}

// The height of a point of a body in the world [m].
double height_of(const Body& body, const Vec3& p) { return body.placement.to_world(p).y; }

Interval heights_of(const Body& body, const Bounds& box) {
  Interval heights{height_of(body, box.min), height_of(body, box.min)};
  for (int corner = 1; corner < 8; ++corner) {
    const Vec3 p((corner & 1 ? box.max : box.min).x, (corner & 2 ? box.max : box.min).y,
                 (corner & 4 ? box.max : box.min).z);
    heights.low = std::min(heights.low, height_of(body, p));
    heights.high = std::max(heights.high, height_of(body, p));
  }
  return heights;
}

// The box of those faces of a tall body that extend below the roof of a vehicle.
Bounds low_box(const Body& body, double below) {
  Bounds low{Vec3(1e300), Vec3(-1e300)};
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    if (!body.mesh.is_live(FaceId(slot))) continue;
    const Triangle t = body.mesh.triangle(FaceId(slot));
    if (std::ranges::none_of(t, [&](const Vec3& p) { return height_of(body, p) < below; })) continue;
    for (const Vec3& p : t) {
      low.min = glm::min(low.min, p);
      low.max = glm::max(low.max, p);
    }
  }
  return low;
}

void cover(const Body& body, BodyId id, const Bounds& box, std::vector<Disc>& discs) {
  const glm::dmat3 turn = glm::mat3_cast(body.placement.orientation);
  const Vec3 middle = body.placement.to_world(0.5 * (box.min + box.max)), half = 0.5 * (box.max - box.min);
  int longest = 0, second = 0;
  double lengths[3], height = 0;
  for (int k = 0; k < 3; ++k) {
    lengths[k] = half[k] * glm::length(Vec2(turn[k].x, turn[k].z));
    height += half[k] * std::abs(turn[k].y);
    if (lengths[k] > lengths[longest]) longest = k;
  }
  if (2 * height < kFlat) return;
  second = longest == 0 ? 1 : 0;
  for (int k = 0; k < 3; ++k) {
    if (k != longest && lengths[k] > lengths[second]) second = k;
  }
  const double radius = std::max(lengths[second], 0.2), reach = std::max(lengths[longest] - radius, 0.0);
  const int count = 1 + static_cast<int>(std::ceil(reach / radius));
  for (int i = 0; i < count; ++i) {
    const double along = count > 1 ? -reach + 2 * reach * i / (count - 1) : 0.0;
    const Vec3 way = half[longest] > 0 ? along * turn[longest] : Vec3(0);
    discs.push_back({middle + way, radius, body.motion.velocity, id});
  }
}

constexpr double kComfort = 2.2;   // m, clearance above which a route makes no detour for more
constexpr double kNarrow = 1.2;    // times the length, per metre less
constexpr double kNoRoom = 20;     // times the length, without room
constexpr float kInTraffic = 6;    // times the length
constexpr double kAroundGoal = 8;  // m
constexpr double kBeside = 1.0;    // m, to traffic
using Spot = FreeSpace::Spot;

class Search {
 public:
  Search(const FreeSpace& space, std::span<const Disc> traffic)
      : space_(space), extra_(space.spots(), 0), costs_(space.spots(), kUnknown), before_(space.spots(), 0) {
    for (const Disc& disc : traffic) mark(disc);
  }

  std::vector<Vec3> find(Spot from, Spot to) {
    KERF_ASSERT(from < space_.spots() && to < space_.spots());
    goal_ = space_.place_of(to);
    costs_[from] = 0;
    open_.push({static_cast<float>(glm::distance(space_.place_of(from), goal_)), from});
    while (!open_.empty()) {
      const auto [estimate, spot] = open_.top();
      open_.pop();
      if (spot == to) return way_to(to, from);
      if (estimate > costs_[spot] + rest(spot) + 1e-3f) continue;  // a cheaper way was found meanwhile
      expand(spot);
    }
    return {};
  }

 private:
  static constexpr float kUnknown = std::numeric_limits<float>::infinity();
  struct Open {
    float estimate;
    Spot spot;
    bool operator<(const Open& other) const {
      return estimate != other.estimate ? estimate > other.estimate : spot > other.spot;
    }
  };

  float rest(Spot spot) const { return static_cast<float>(glm::distance(space_.place_of(spot), goal_)); }

  void mark(const Disc& disc) {
    const double reach = disc.radius + kBeside;
    for (double dz = -reach; dz <= reach; dz += FreeSpace::kCell) {
      for (double dx = -reach; dx <= reach; dx += FreeSpace::kCell) {
        if (dx * dx + dz * dz <= reach * reach)
          extra_[space_.spot_at(disc.centre + Vec3(dx, 0, dz))] = kInTraffic;
      }
    }
  }

  void expand(Spot spot) {
    const bool room = space_.has_room(spot);
    space_.for_each_beside(spot, [&](Spot to, double metres) {
      if (room && !space_.has_room(to)) return;
      const double lacking = std::max(0.0, kComfort - space_.clearance(to));
      const double factor = (room ? 1 : kNoRoom) + kNarrow * lacking + extra_[to];
      const float cost = costs_[spot] + static_cast<float>(metres * factor);
      if (cost >= costs_[to]) return;
      costs_[to] = cost;
      before_[to] = spot;
      open_.push({cost + rest(to), to});
    });
  }

  std::vector<Vec3> way_to(Spot spot, Spot from) const {
    std::vector<Vec3> way{space_.place_of(spot)};
    while (spot != from) {
      spot = before_[spot];
      way.push_back(space_.place_of(spot));
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  const FreeSpace& space_;
  Vec3 goal_{0};
  std::vector<float> extra_;  // by spot, times the length
  std::vector<float> costs_;
  std::vector<Spot> before_;
  std::priority_queue<Open> open_;
};

constexpr double kArcStep = 0.15;             // s
constexpr double kGaining = 4, kBraking = 7;  // m/s^2
constexpr double kHalfWidth = 1.0;            // m, of the discs of a vehicle
constexpr double kDeeper = 0.04;              // m
constexpr double kHeight = 2;                 // m, between floors
constexpr double kMaxSide = 8;                // m/s^2, across

// Measures how far the discs of a vehicle reach into obstacles.
class Surrounds {
 public:
  Surrounds(const FreeSpace& space, std::span<const Disc> traffic, const Course& course)
      : space_(space), reach_(course.reach) {
    const double far = kArcTime * (std::abs(course.speed) + 8) + reach_;
    for (const Disc& disc : traffic) {
      const double away = glm::distance(disc.centre, course.at) - disc.radius;
      if (away < far && std::abs(disc.centre.y - course.at.y) < kHeight) near_.push_back(disc);
    }
  }

  // The minimum clearance of the three discs that cover the vehicle [m].
  double room_at(const Vec3& at, const Vec3& ahead) const {
    if (space_.spots() == 0) return FreeSpace::kFar;
    double room = FreeSpace::kFar;
    for (const double along : {-1.0, 0.0, 1.0})
      room = std::min(room, space_.clearance(space_.spot_at(at + along * reach_ * ahead)));
    return room;
  }

  // The deepest overlap with traffic after some seconds [m]; 0 if there is none.
  double overlap_at(const Vec3& at, const Vec3& ahead, double seconds) const {
    double deepest = 0;
    for (const Disc& disc : near_) {
      const Vec3 centre = disc.centre + seconds * disc.velocity;
      for (const double along : {-1.0, 0.0, 1.0}) {
        const Vec3 way = at + along * reach_ * ahead - centre;
        const double apart = std::sqrt(way.x * way.x + way.z * way.z);
        deepest = std::max(deepest, disc.radius + kHalfWidth - apart);
      }
    }
    return deepest;
  }

  double height_at(const Vec3& at) const {
    return space_.spots() == 0 ? at.y : space_.place_of(space_.spot_at(at)).y;
  }

 private:
  const FreeSpace& space_;
  double reach_;
  std::vector<Disc> near_;
};

constexpr int kSecond = static_cast<int>(kTicksPerSecond);
constexpr int kLookEvery = 6, kPlanEvery = kSecond;  // ticks
constexpr std::array kSteers{0.0, 0.25, -0.25, 0.55, -0.55, 1.0, -1.0};
constexpr double kCruise = 15, kBack = 4.5;  // m/s
constexpr double kAhead = 9;                 // m, along the route
constexpr double kNear = 3;                  // m, from the end of a route at which it is complete
constexpr double kAway = 0.6;                // m, motion below which a vehicle is held
constexpr int kHeld = kSecond * 3 / 4;       // ticks for which it is held before it tries the other direction

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

std::vector<Disc> others_of(const DriverView& view) {
  std::vector<Disc> others(view.traffic.begin(), view.traffic.end());
  std::erase_if(others, [&](const Disc& disc) { return disc.body == view.own().chassis; });
  return others;
}

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

std::vector<Disc> find_traffic(const World& world, std::span<const Vehicle> vehicles) {
  std::vector<Disc> discs;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.pinned || body.hidden || body.tree.leaf_count() == 0) continue;
    Bounds box = body.bounds();
    if (glm::length(box.max - box.min) < kSmall || is_carried(vehicles, id)) continue;
    const Interval heights = heights_of(body, box);
    if (heights.high - heights.low > kTall) box = low_box(body, heights.low + kUnderRoof);
    if (box.min.x <= box.max.x) cover(body, id, box, discs);
  }
  return discs;
}

std::vector<Vec3> find_route(const FreeSpace& space, std::span<const Disc> traffic, const Vec3& from,
                             const Vec3& to) {
  if (space.spots() == 0) return {from, to};
  const Spot goal = space.with_room_near(to, kAroundGoal);
  return goal == space.spots() ? std::vector<Vec3>{} : Search(space, traffic).find(space.spot_at(from), goal);
}

ArcEnd follow_arc(const FreeSpace& space, std::span<const Disc> traffic, const Course& course,
                  const Arc& arc) {
  KERF_ASSERT(course.wheelbase > 0);
  const Surrounds around(space, traffic, course);
  Vec3 at = course.at;
  double heading = course.heading, speed = course.speed;
  ArcEnd end{at, heading, kArcTime, 0, around.room_at(at, direction_of(heading, 0))};
  double least = std::min(end.room, FreeSpace::kVehicle);
  double deepest = around.overlap_at(at, direction_of(heading, 0), 0);
  for (double t = kArcStep; t < kArcTime + 0.5 * kArcStep; t += kArcStep) {
    const double rate = std::abs(arc.speed) < std::abs(speed) || arc.speed * speed < 0 ? kBraking : kGaining;
    speed = towards(speed, arc.speed, rate * kArcStep);
    const SinCos lock = sin_cos(arc.steer * full_lock(std::abs(speed)));
    double turning = speed * lock.sin / (lock.cos * course.wheelbase);
    if (std::abs(turning * speed) > kMaxSide) turning *= kMaxSide / std::abs(turning * speed);
    heading = wrapped(heading + turning * kArcStep);
    const Vec3 ahead = direction_of(heading, 0);
    Vec3 next = at + speed * kArcStep * ahead;
    next.y = around.height_at(next);
    const double room = around.room_at(next, ahead), overlap = around.overlap_at(next, ahead, t);
    if (room < least - kDeeper || overlap > deepest + kDeeper) {
      end.free_s = t - kArcStep;
      break;
    }
    least = std::min(FreeSpace::kVehicle, std::max(least, room));
    deepest = std::min(deepest, overlap);
    end.free_m += glm::distance(at, next);
    end.room = std::min(end.room, room);
    at = next;
    end.at = at;
    end.heading = heading;
  }
  return end;
}

// Staggers the drivers, so that those that start together do not plan in the same tick.
Steering::Steering(uint64_t seed) : random_(seed), side_(random_.unit() < 0.5 ? -1 : 1) {
  look_in_ = 1 + static_cast<int>(random_.below(kLookEvery));
}

Vec3 Steering::select_goal(const DriverView& view, const Course& course, const Vec3& at,
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
  KERF_ASSERT(!route_.empty());
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

void Steering::select_arc(const DriverView& view, const Course& course, double share) {
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

// Detects missing progress, and then tries the other direction for a while.
void Steering::record_progress(const Course& course, const Controls& controls) {
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
  record_progress(course, controls);
  controls.handbrake = false;
  if (--turn_in_ <= 0) {
    turn_in_ = 3 * kSecond + static_cast<int>(random_.below(6 * kSecond));
    if (random_.unit() < 0.4) side_ = -side_;
  }
  const bool done = route_.empty() || flat_distance(route_.back(), course.at) < kNear;
  if (--plan_in_ <= 0 || (done && plan_in_ < kPlanEvery - kSecond / 4)) {
    plan_in_ = kPlanEvery - static_cast<int>(random_.below(kPlanEvery / 8));
    route_ = find_route(view.space, others_of(view), course.at, select_goal(view, course, at, distance));
  }
  if (--look_in_ <= 0) {
    look_in_ = kLookEvery;
    select_arc(view, course, share);
  }
  controls.steer = share_of_full(arc_.steer);
  const double safe = std::sqrt(2 * 5.0 * std::max(free_m_ - 0.5, 0.1));  // m/s, to stop in time
  const double wanted = std::clamp(arc_.speed, -safe, safe);
  controls.throttle = share_of_full(0.6 * (wanted - course.speed) + (wanted > 0 ? 0.1 : -0.1));
}

}  // namespace kerf
