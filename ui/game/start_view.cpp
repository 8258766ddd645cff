#include "ui/game/start_view.h"

#include <cmath>

#include "core/base/angle.h"
#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kAway = 6.6, kHeight = 1.5, kLooksAt = 0.8;   // m
constexpr double kMiddle = 0.75, kSwing = 0.35, kRate = 0.12;  // rad from ahead, and rad/s
constexpr double kAside = 0.16;                                // of the distance

}  // namespace

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
