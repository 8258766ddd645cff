#include "ui/game/replay_camera.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kNearest = 8, kFarthest = 13;  // m
constexpr double kFarApart = 12;                // m, between vehicles that do not fit into one picture
constexpr double kChassisMiddle = 0.8;          // m, above the ground
constexpr double kTurnRate = 0.16;                  // rad/s
constexpr double kMiddleRate = 3;               // 1/s, at which the middle is followed
constexpr double kPatience = 0.5;               // s that a vehicle may be hidden
constexpr int kAngles = 24;
constexpr double kLarge = 1.6;          // m, the diagonal of what hides something
constexpr double kEyeClearance = 0.4;   // m, of the eye from what is behind it
constexpr double kLeastDistance = 1.5;  // m, of the eye from what it watches

Vec3 middle_of(const Match& match, size_t vehicle) {
  return match.world().body(match.vehicles()[vehicle].chassis).placement.to_world({0, kChassisMiddle, 0});
}

}  // namespace

ReplayCamera::Aim ReplayCamera::aim(const Match& match) const {
  const Vec3 own = middle_of(match, Match::kPlayer), other = middle_of(match, other_);
  const double apart = glm::length(other - own);
  // What happens is at the other vehicle. It is kept nearer to the middle of the picture, and where the
  // player's is too far away it is shown alone.
  if (apart > kFarApart) return {other, kNearest};
  return {glm::mix(own, other, 0.6), std::clamp(3 + 0.85 * apart, kNearest, kFarthest)};
}

Vec3 ReplayCamera::eye_at(const Aim& aim, const Stand& stand) {
  return aim.middle +
         aim.distance * stand.nearness * (direction_of(stand.angle, 0) + Vec3(0, stand.height, 0));
}

// The vehicle to which it happens matters more than the player's.
int ReplayCamera::hidden_from(const Match& match, const Sight& sight, const Vec3& eye) const {
  const auto hides = [&](size_t vehicle) {
    const Vec3 way = middle_of(match, vehicle) - eye;
    const double length = glm::length(way);
    if (!(length > 0)) return false;
    const auto hit = sight.nearest({eye, way / length}, length, [&](BodyId id) { return stops(match, id); });
    return hit.has_value();
  };
  return (hides(other_) ? 2 : 0) + (hides(Match::kPlayer) ? 1 : 0);
}

ReplayCamera::Stand ReplayCamera::best_stand(const Match& match, const Sight& sight, const Aim& aim) const {
  const Vec3 own = middle_of(match, Match::kPlayer), other = middle_of(match, other_);
  // From beside the line between the vehicles both are seen whole.
  const double beside = heading_of(other - own) + 0.5 * kPi;
  Stand best{beside};
  int least = hidden_from(match, sight, eye_at(aim, best));
  for (const auto& [height, nearness] :
       {std::pair{0.34, 1.0}, {0.12, 1.0}, {0.12, 0.6}, {0.8, 1.0}, {0.3, 0.4}}) {
    for (int i = 0; i < kAngles && least > 0; ++i) {
      const int step = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
      const Stand stand{beside + step * (2 * kPi / kAngles), height, nearness};
      const int hidden = hidden_from(match, sight, eye_at(aim, stand));
      if (hidden >= least) continue;
      least = hidden;
      best = stand;
    }
  }
  return best;
}

// Walls, other vehicles, containers and the like: whatever is large, but for the two vehicles that are
// watched.
bool ReplayCamera::stops(const Match& match, BodyId id) const {
  if (match.is_wall(id)) return true;
  const size_t vehicle = match.vehicle_of(id);
  if (vehicle == other_ || vehicle == Match::kPlayer) return false;
  const Bounds box = match.world().body(id).bounds();
  return glm::length(box.max - box.min) > kLarge;
}

// On the way from the vehicle to which it happens, which stands in the open; the middle may lie in a wall.
Vec3 ReplayCamera::free_eye(const Match& match, const Sight& sight) const {
  const Vec3 from = middle_of(match, other_), way = eye_ - from;
  const double length = glm::length(way);
  if (!(length > kLeastDistance)) return eye_;
  const auto hit = sight.nearest({from, way / length}, length + kEyeClearance,
                                 [&](BodyId id) { return stops(match, id); });
  if (!hit) return eye_;
  return from + way / length * std::max(0.5 * hit->length, hit->length - kEyeClearance);
}

void ReplayCamera::stand_at_best(const Match& match, const Sight& sight, const Aim& aim) {
  stand_ = best_stand(match, sight, aim);
  middle_ = aim.middle;
  eye_ = eye_at(aim, stand_);
}

void ReplayCamera::follow(const Match& match, double seconds) {
  KERF_ASSERT(other_ < match.vehicles().size());
  const Aim aim = this->aim(match);
  const Sight sight(match.world());
  if (!placed_) stand_at_best(match, sight, aim);
  placed_ = true;
  const double share = 1 - std::exp(-kMiddleRate * seconds);
  stand_.angle += kTurnRate * seconds;
  middle_ += (aim.middle - middle_) * share;
  eye_ = glm::mix(eye_, eye_at({middle_, aim.distance}, stand_), share);
  free_eye_ = free_eye(match, sight);
  const int hidden = hidden_from(match, sight, eye_);
  hidden_s_ = hidden > 0 ? hidden_s_ + seconds : 0;
  if (hidden_s_ < kPatience) return;
  hidden_s_ = 0;
  const Stand better = best_stand(match, sight, aim);
  if (hidden_from(match, sight, eye_at(aim, better)) >= hidden) return;
  stand_at_best(match, sight, aim);
  free_eye_ = free_eye(match, sight);
}

CameraView ReplayCamera::view(double aspect, double field_of_view) const {
  const Vec3 right = look_at(free_eye_, middle_, aspect).right;
  CameraView view = look_at(free_eye_, middle_ - right * (aside_ * glm::length(middle_ - free_eye_)), aspect);
  view.tan_half_fov = std::tan(0.5 * field_of_view * kPi / 180);
  return view;
}

}  // namespace kerf
