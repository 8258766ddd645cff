#include "core/game/vehicle/crash.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/joints/hold_parts.h"

namespace kerf {

namespace {

constexpr double kReach = 0.8, kMoreReach = 0.07;  // m at kCrash, and m for each m/s more
constexpr double kMostReach = 1.6;                 // m

}  // namespace

Vec3 pushed_at(const Body& chassis, const Vec3& change) {
  const Bounds box = chassis.bounds();
  const Vec3 middle = 0.5 * (box.min + box.max), half = 0.5 * (box.max - box.min);
  const Vec3 way = glm::conjugate(chassis.placement.orientation) * -change;
  double share = 1e300;  // of `way` that leads from the middle to the side
  for (const int axis : {0, 2}) {
    if (way[axis] != 0) share = std::min(share, half[axis] / std::abs(way[axis]));
  }
  if (share == 1e300) share = 0;
  return chassis.placement.to_world(middle + share * Vec3(way.x, 0, way.z));
}

bool let_go_near(World& world, const Vehicle& vehicle, const Vec3& at, double change) {
  KERF_ASSERT(change >= kCrash);
  KERF_ASSERT(vehicle.model);
  Body& chassis = world.body(vehicle.chassis);
  const Vec3 place = chassis.placement.to_body(at);
  const double reach = std::min(kMostReach, kReach + kMoreReach * (change - kCrash));
  const std::vector<bool>& breaks = vehicle.model->breaks;
  Joints joints = world.joints();
  size_t own = 0;
  bool any = false;
  for (Joint& joint : joints.all) {
    if (joint.body != chassis.loaded_as) continue;
    KERF_ASSERT(own < breaks.size());
    const bool near = glm::distance(joint.anchor, place) <= reach && !joint.sides[0].faces.empty();
    if (!breaks[own++] || !near) continue;
    joint.sides[0].faces.clear();
    joint.sides[1].faces.clear();
    any = true;
  }
  if (!any) return false;
  world.set_joints(std::move(joints));
  ask_joints(world, chassis, {}, true);
  return true;
}

}  // namespace kerf
