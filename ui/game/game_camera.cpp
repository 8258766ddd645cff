#include "ui/game/game_camera.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/assert.h"
#include "core/base/unit_vector.h"

namespace kerf {

namespace {

constexpr double kOverPivot = 0.42, kBehindPivot = 0.75, kBeside = 0.5;  // m, the eye on the roof
constexpr double kChaseBack = 6.8, kChaseUp = 2.5, kChaseLook = 1.1;     // m
constexpr double kHeightRate = 14;   // 1/s, at which the eye follows the vehicle upwards
constexpr double kClearance = 0.35;  // m, of the camera before walls
constexpr double kShakeFade = 5;     // 1/s
constexpr double kShakeSize = 0.05;  // m
constexpr double kShakeSpeed = 41;   // rad/s
constexpr double kTarget = 10;       // m, the point looked at

Vec3 level(const Vec3& v) {
  const Vec3 flat(v.x, 0, v.z);
  const double length = glm::length(flat);
  return length > 0 ? flat / length : Vec3(0, 0, 1);
}

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

}  // namespace kerf
