#include "core/game/vehicle/glide.h"

#include <algorithm>
#include <cmath>

#include "core/game/vehicle/rigid_motion.h"

namespace kerf {

namespace {

constexpr double kUpright = 0.5;       // the cosine of the lean
constexpr double kBall = 0.42;         // m, the radius of the balls
constexpr double kAboveGround = 0.12;  // m, of the balls above the lowest point
constexpr double kApart = 0.8;         // m, between balls
constexpr double kFriction = 0.2;
constexpr double kRebound = 0.15;
constexpr double kSlop = 0.005;  // m, by which balls may reach into faces
constexpr int kPasses = 2;

struct Extent {
  double left, right, low, back, front;  // m, in the frame of the vehicle
};

// The extent of what is left of the chassis, and of the wheels.
Extent extent_of(const Body& chassis, const Vehicle& vehicle) {
  const Bounds box = chassis.bounds();
  Extent e{box.max.x, box.min.x, box.min.y, box.min.z, box.max.z};
  for (size_t i = 0; i < vehicle.wheels.size(); ++i) {
    if (!vehicle.wheels[i].attached) continue;
    const WheelDescription& wheel = vehicle.what().wheels[i];
    e.left = std::max(e.left, wheel.hub.x + 0.1);
    e.right = std::min(e.right, wheel.hub.x - 0.1);
    e.back = std::min(e.back, wheel.hub.z - 0.7 * wheel.radius);
    e.front = std::max(e.front, wheel.hub.z + 0.7 * wheel.radius);
  }
  return e;
}

std::vector<Vec3> balls_of(const Extent& e) {
  const double y = std::max(e.low, 0.0) + kAboveGround + kBall;
  const double back = std::min(e.back + kBall, 0.5 * (e.back + e.front)), front = e.back + e.front - back;
  const double right = std::min(e.right + kBall, 0.5 * (e.right + e.left)), left = e.right + e.left - right;
  const int rows = 1 + static_cast<int>(std::ceil((front - back) / kApart));
  std::vector<Vec3> balls;
  for (int i = 0; i < rows; ++i) {
    const double z = back + (front - back) * i / std::max(rows - 1, 1);
    balls.insert(balls.end(), {{left, y, z}, {right, y, z}});
  }
  return balls;
}

// Takes away the velocity of a point against a unit normal, and some of that across it.
void stop(RigidMotion& motion, const Vec3& at, const Vec3& normal) {
  const double against = -glm::dot(motion.velocity_at(at), normal);
  if (against <= 0) return;
  const double impulse = (1 + kRebound) * against / motion.response(at, normal);
  motion.push(at, impulse * normal);
  const Vec3 velocity = motion.velocity_at(at), across = velocity - glm::dot(velocity, normal) * normal;
  const double speed = glm::length(across);
  if (!(speed > 0)) return;
  const Vec3 along = across / speed;
  motion.push(at, -std::min(kFriction * impulse, speed / motion.response(at, along)) * along);
}

}  // namespace

bool is_upright(const World& world, const Vehicle& vehicle) {
  return (world.body(vehicle.chassis).placement.orientation * Vec3(0, 1, 0)).y > kUpright;
}

void glide_along(World& world, const Vehicle& vehicle, const Obstacles& obstacles) {
  Body& chassis = world.body(vehicle.chassis);
  if (chassis.mesh.live_faces() == 0 || chassis.motion.asleep || !is_upright(world, vehicle)) return;
  const std::vector<Vec3> balls = balls_of(extent_of(chassis, vehicle));
  for (int sweep = 0; sweep < kPasses; ++sweep) {
    for (const Vec3& ball : balls) {
      const Vec3 centre = chassis.placement.to_world(ball);
      const auto touch = obstacles.touched_by(centre, kBall);
      if (!touch) continue;
      const Vec3 way(centre.x - touch->at.x, 0, centre.z - touch->at.z);
      const double length = glm::length(way);
      if (!(length > 0)) continue;
      const Vec3 normal = way / length;
      RigidMotion motion(chassis);
      stop(motion, touch->at, normal);
      motion.store(chassis);
      chassis.placement.position += std::max(0.0, kBall - touch->distance - kSlop) * normal;
    }
  }
}

}  // namespace kerf
