#include "ui/game/game_camera.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/geometry.h"

namespace kerf {

namespace {

constexpr double kOverPivot = 0.42, kBehindPivot = 0.75, kBeside = 0.5;  // m, the eye on the roof
constexpr double kChaseBack = 6.8, kChaseUp = 2.5, kChaseLook = 1.1;     // m
constexpr double kHeightRate = 14;   // 1/s, smoothing rate of the eye's height
constexpr double kClearance = 0.35;  // m, between the camera and walls
constexpr double kShakeFade = 5;     // 1/s
constexpr double kShakeSize = 0.05;  // m
constexpr double kShakeSpeed = 41;   // rad/s
constexpr double kTarget = 10;       // m, distance of the view target

Vec3 level(const Vec3& v) {
  const Vec3 flat(v.x, 0, v.z);
  const double length = glm::length(flat);
  return length > 0 ? flat / length : Vec3(0, 0, 1);
}

constexpr double kNearest = 8, kFarthest = 19;  // m
constexpr double kFarApart = 19;                // m, between vehicles that do not fit into one frame
constexpr double kChassisMiddle = 0.8;          // m, above the ground
constexpr double kTurnRate = 0.16;              // rad/s
constexpr double kMiddleRate = 3;               // 1/s, smoothing rate of the middle
constexpr double kPatience = 0.5;               // s that a vehicle may be hidden
constexpr int kAngles = 24;
constexpr double kLarge = 1.6;         // m, minimum diagonal of an occluder
constexpr double kEyeClearance = 0.4;  // m, between the eye and a body behind it
constexpr double kMinDistance = 1.5;   // m, between the eye and its target

Vec3 middle_of(const Match& match, size_t vehicle) {
  return match.world().body(match.vehicles()[vehicle].chassis).placement.to_world({0, kChassisMiddle, 0});
}

constexpr double kAway = 6.6, kHeight = 1.5, kLooksAt = 0.8;   // m
constexpr double kMiddle = 0.75, kSwing = 0.35, kRate = 0.12;  // rad from ahead, and rad/s
constexpr double kAside = 0.16;                                // fraction of the distance

}  // namespace

Vec3 aim_of(const Controls& controls) {
  return direction_of(controls.heading * Controls::kAimStep, controls.pitch * Controls::kAimStep);
}

Vec3 GameCamera::wanted_eye(const Match& match, const Vec3& aim) const {
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  const Placement& chassis = match.world().body(own.chassis).placement;
  const Vec3 pivot = chassis.to_world(own.what().turret.barrel.pivot);
  if (viewpoint == Viewpoint::kRoof) {
    const Vec3 ahead = level(aim), left = glm::cross(Vec3(0, 1, 0), ahead);
    return pivot + Vec3(0, kOverPivot, 0) - kBehindPivot * ahead + kBeside * left;
  }
  const Vec3 middle = chassis.to_world({0, kChaseLook, 0});
  const Vec3 wanted = middle - level(aim) * kChaseBack + Vec3(0, kChaseUp - kChaseLook, 0);
  const Vec3 way = wanted - middle;
  const double length = glm::length(way);
  const Sight sight(match.world());
  const auto wall = sight.nearest({middle, way / length}, length + kClearance,
                                  [&](BodyId id) { return match.is_wall(id); });
  return wall ? middle + way * (std::max(0.5, wall->length - kClearance) / length) : wanted;
}

void GameCamera::follow(const Match& match, const Vec3& aim, double seconds) {
  KERF_ASSERT(is_unit(aim) && seconds >= 0);
  const Vec3 wanted = wanted_eye(match, aim);
  const double share = placed_ ? 1 - std::exp(-kHeightRate * seconds) : 1;
  height_ += (wanted.y - height_) * share;
  eye_ = {wanted.x, height_, wanted.z};
  target_ = eye_ + aim * kTarget;
  if (viewpoint == Viewpoint::kChase) target_.y -= 0.06 * kTarget;
  phase_ += kShakeSpeed * seconds;
  shake_ *= std::exp(-kShakeFade * seconds);
  placed_ = true;
}

void GameCamera::shake(double strength) { shake_ = std::min(1.0, std::max(shake_, strength)); }

CameraView GameCamera::view(double aspect, double field_of_view) const {
  KERF_ASSERT(aspect > 0 && field_of_view > 0 && field_of_view < 180);
  const Vec3 jolt(0.6 * std::sin(1.7 * phase_), std::sin(phase_), 0);
  CameraView view = look_at(eye_ + jolt * (kShakeSize * shake_), target_, aspect);
  view.tan_half_fov = std::tan(0.5 * field_of_view * kPi / 180);
  return view;
}

ReplayCamera::Aim ReplayCamera::aim(const Match& match) const {
  const Vec3 own = middle_of(match, Match::kPlayer), other = middle_of(match, filmed(match));
  const double apart = glm::length(other - own);
  // The action is at the other vehicle. It is kept closer to the middle of the frame, and shown alone if
  // the player's is too far away.
  if (apart > kFarApart) return {other, kNearest};
  return {glm::mix(own, other, 0.6), std::clamp(3 + 0.85 * apart, kNearest, kFarthest)};
}

Vec3 ReplayCamera::eye_at(const Aim& aim, const EyePosition& position) {
  return aim.middle +
         aim.distance * position.nearness * (direction_of(position.angle, 0) + Vec3(0, position.height, 0));
}

// The other vehicle, where the action is, matters more than the player's.
int ReplayCamera::hidden_from(const Match& match, const Sight& sight, const Vec3& eye) const {
  const auto hides = [&](size_t vehicle) {
    const Vec3 way = middle_of(match, vehicle) - eye;
    const double length = glm::length(way);
    if (!(length > 0)) return false;
    const auto hit = sight.nearest({eye, way / length}, length, [&](BodyId id) { return stops(match, id); });
    return hit.has_value();
  };
  return (hides(filmed(match)) ? 2 : 0) + (hides(Match::kPlayer) ? 1 : 0);
}

ReplayCamera::EyePosition ReplayCamera::best_eye_position(const Match& match, const Sight& sight,
                                                          const Aim& aim) const {
  const Vec3 own = middle_of(match, Match::kPlayer), other = middle_of(match, filmed(match));
  // A view across the line between the vehicles shows both whole.
  const double beside = heading_of(other - own) + 0.5 * kPi;
  EyePosition best{beside};
  int least = hidden_from(match, sight, eye_at(aim, best));
  for (const auto& [height, nearness] :
       {std::pair{0.34, 1.0}, {0.12, 1.0}, {0.12, 0.6}, {0.8, 1.0}, {0.3, 0.4}}) {
    for (int i = 0; i < kAngles && least > 0; ++i) {
      const int step = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
      const EyePosition position{beside + step * (2 * kPi / kAngles), height, nearness};
      const int hidden = hidden_from(match, sight, eye_at(aim, position));
      if (hidden >= least) continue;
      least = hidden;
      best = position;
    }
  }
  return best;
}

// Walls, other vehicles, containers and similar large bodies, except the two filmed vehicles.
bool ReplayCamera::stops(const Match& match, BodyId id) const {
  if (match.is_wall(id)) return true;
  const size_t vehicle = match.vehicle_of(id);
  if (vehicle == filmed(match) || vehicle == Match::kPlayer) return false;
  const Bounds box = match.world().body(id).bounds();
  return glm::length(box.max - box.min) > kLarge;
}

// Starts at the other vehicle, which is in the open; the middle may be inside a wall.
Vec3 ReplayCamera::free_eye(const Match& match, const Sight& sight) const {
  const Vec3 from = middle_of(match, filmed(match)), way = eye_ - from;
  const double length = glm::length(way);
  if (!(length > kMinDistance)) return eye_;
  const auto hit = sight.nearest({from, way / length}, length + kEyeClearance,
                                 [&](BodyId id) { return stops(match, id); });
  if (!hit) return eye_;
  return from + way / length * std::max(0.5 * hit->length, hit->length - kEyeClearance);
}

void ReplayCamera::move_to_best_position(const Match& match, const Sight& sight, const Aim& aim) {
  eye_position_ = best_eye_position(match, sight, aim);
  middle_ = aim.middle;
  eye_ = eye_at(aim, eye_position_);
}

void ReplayCamera::follow(const Match& match, double seconds) {
  const Aim aim = this->aim(match);
  const Sight sight(match.world());
  if (!placed_) move_to_best_position(match, sight, aim);
  placed_ = true;
  const double share = 1 - std::exp(-kMiddleRate * seconds);
  eye_position_.angle += kTurnRate * seconds;
  middle_ += (aim.middle - middle_) * share;
  eye_ = glm::mix(eye_, eye_at({middle_, aim.distance}, eye_position_), share);
  free_eye_ = free_eye(match, sight);
  const int hidden = hidden_from(match, sight, eye_);
  hidden_s_ = hidden > 0 ? hidden_s_ + seconds : 0;
  if (hidden_s_ < kPatience) return;
  hidden_s_ = 0;
  const EyePosition better = best_eye_position(match, sight, aim);
  if (hidden_from(match, sight, eye_at(aim, better)) >= hidden) return;
  move_to_best_position(match, sight, aim);
  free_eye_ = free_eye(match, sight);
}

CameraView ReplayCamera::view(double aspect, double field_of_view) const {
  const Vec3 right = look_at(free_eye_, middle_, aspect).right;
  CameraView view = look_at(free_eye_, middle_ - right * (aside_ * glm::length(middle_ - free_eye_)), aspect);
  view.tan_half_fov = std::tan(0.5 * field_of_view * kPi / 180);
  return view;
}

CameraView start_view(const Match& match, double seconds, double aspect, double field_of_view) {
  KERF_ASSERT(seconds >= 0 && aspect > 0 && field_of_view > 0 && field_of_view < 180);
  const Placement& car = match.world().body(match.vehicles()[Match::kPlayer].chassis).placement;
  const double ahead = heading_of(car.orientation * Vec3(0, 0, 1));
  const Vec3 out = direction_of(wrapped(ahead + kMiddle + kSwing * std::sin(kRate * seconds)), 0);
  const Vec3 left = glm::cross(Vec3(0, 1, 0), -out) * (kAside * kAway * aspect);
  const Vec3 eye = car.position + kAway * out + Vec3(0, kHeight, 0);
  const Vec3 target = car.position + Vec3(0, kLooksAt, 0);
  CameraView view = look_at(eye + left, target + left, aspect);
  view.tan_half_fov = std::tan(0.5 * field_of_view * kPi / 180);
  return view;
}

}  // namespace kerf
