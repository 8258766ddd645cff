#include "core/game/driver/arc.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/angle.h"
#include "core/game/vehicle/drive.h"

namespace kerf {

namespace {

constexpr double kArcStep = 0.15;                // s
constexpr double kGaining = 4, kBraking = 7;  // m/s^2
constexpr double kHalfWidth = 1.0;            // m, of the discs of a vehicle
constexpr double kDeeper = 0.04;              // m
constexpr double kHeight = 2;                 // m, between floors
constexpr double kMostSide = 8;               // m/s^2, across

// How far the discs of a vehicle reach into what is around it.
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

  // The least clearance of the three discs that cover the vehicle, m.
  double room_at(const Vec3& at, const Vec3& ahead) const {
    if (space_.spots() == 0) return FreeSpace::kFar;
    double room = FreeSpace::kFar;
    for (const double along : {-1.0, 0.0, 1.0})
      room = std::min(room, space_.clearance(space_.spot_at(at + along * reach_ * ahead)));
    return room;
  }

  // The deepest overlap with traffic after some seconds, m; 0 where there is none.
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

double towards(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

}  // namespace

ArcEnd follow_arc(const FreeSpace& space, std::span<const Disc> traffic, const Course& course,
                  const Arc& arc) {
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
    if (std::abs(turning * speed) > kMostSide) turning *= kMostSide / std::abs(turning * speed);
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

}  // namespace kerf
