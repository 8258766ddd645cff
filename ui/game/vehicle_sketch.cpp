#include "ui/game/vehicle_sketch.h"

#include <algorithm>

#include "core/base/assert.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr ImU32 kLost = IM_COL32(0xff, 0x6a, 0x4d, 255);

// The plan of a vehicle on the screen: its front is upwards.
struct Plan {
  ImVec2 middle;
  float scale;  // pixels per metre
  ImVec2 operator()(double x, double z) const {
    return {middle.x - scale * static_cast<float>(x), middle.y - scale * static_cast<float>(z)};
  }
};

// Half the length and width (m) that wheels, laser and vital parts take, with some body around them.
Vec2 half_size(const Vehicle& vehicle) {
  Vec2 half(0.5, 1);
  for (const WheelDescription& w : vehicle.what().wheels) {
    half.x = std::max(half.x, std::abs(w.hub.x) + 0.08);
    half.y = std::max(half.y, std::abs(w.hub.z) + 0.8);
  }
  return half;
}

void box(const HudPaint& paint, ImVec2 a, ImVec2 b, ImU32 colour, bool works) {
  const ImVec2 low(std::min(a.x, b.x), std::min(a.y, b.y)), high(std::max(a.x, b.x), std::max(a.y, b.y));
  if (works) {
    paint.list().AddRectFilled(low, high, colour, 2);
    return;
  }
  paint.list().AddRect(low, high, kLost, 2);
  paint.line(low, high, kLost, 1.5f);
  paint.line({low.x, high.y}, {high.x, low.y}, kLost, 1.5f);
}

}  // namespace

void draw_vehicle_sketch(const Vehicle& vehicle, const HudPaint& paint, ImVec2 middle, float height) {
  const Vec2 half = half_size(vehicle);
  const Plan plan{middle, height / static_cast<float>(2 * half.y)};
  const ImU32 works = colours::kPictureText, outline = vehicle.alive ? colours::kPictureSecondary : kLost;
  paint.list().AddRect(plan(half.x * 0.9, half.y), plan(-half.x * 0.9, -half.y), outline, height * 0.09f, 0,
                       2);
  const auto& wheels = vehicle.what().wheels;
  KERF_ASSERT(vehicle.wheels.size() == wheels.size());
  for (size_t i = 0; i < wheels.size(); ++i) {
    const Vec3& hub = wheels[i].hub;
    const double r = wheels[i].radius;
    box(paint, plan(hub.x - 0.11, hub.z - r), plan(hub.x + 0.11, hub.z + r), works,
        vehicle.wheels[i].attached);
  }
  const size_t vitals = vehicle.what().vitals.size();
  KERF_ASSERT(vehicle.vital_works.size() == vitals && vehicle.model->vital_centres.size() == vitals);
  for (size_t i = 0; i < vitals; ++i) {
    const Vec3& at = vehicle.model->vital_centres[i];
    const bool engine = vehicle.what().vitals[i].kind == VitalDescription::Kind::kEngine;
    const double w = engine ? 0.34 : 0.2, l = engine ? 0.24 : 0.22;
    box(paint, plan(at.x - w, at.z - l), plan(at.x + w, at.z + l), colours::kPictureSecondary,
        vehicle.vital_works[i]);
  }
  const Vec3& pivot = vehicle.what().turret.pivot;
  const float radius = 0.17f * plan.scale;
  const ImU32 laser = vehicle.gun.works() ? colours::accent() : kLost;
  paint.circle(plan(pivot.x, pivot.z), radius, laser, 2);
  const double yaw = vehicle.gun.yaw;
  const Vec2 along(std::sin(yaw), std::cos(yaw));
  if (vehicle.gun.works())
    paint.line(plan(pivot.x, pivot.z), plan(pivot.x + 0.55 * along.x, pivot.z + 0.55 * along.y), laser, 2);
}

}  // namespace kerf
