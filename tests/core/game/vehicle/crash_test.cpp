#include "core/game/vehicle/vehicle.h"

#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "core/joints/joined_parts.h"
#include "tests/support/game_files.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

TEST(Crash, locates_the_impact_on_the_side_facing_the_push) {
  test::LoneVehicle lone;
  Body& chassis = lone.world.body(lone.vehicle.chassis);
  const Bounds box = chassis.bounds();
  for (uint64_t seed = 1; seed <= runs(50); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    chassis.placement = {{random.uniform(-9, 9), 0, 3}, axis_angle({0, 1, 0}, random.uniform(-3, 3))};
    const Vec3 change = random.uniform(1, 30) * direction_of(random.uniform(-3, 3), random.uniform(-1, 1));
    const Vec3 at = chassis.placement.to_body(pushed_at(chassis, change));
    const Vec3 from_middle = at - 0.5 * (box.min + box.max);
    const Vec3 push = glm::conjugate(chassis.placement.orientation) * change;
    EXPECT_LT(from_middle.x * push.x + from_middle.z * push.z, 0);
    const double out = std::max(std::abs(from_middle.x) / (0.5 * (box.max.x - box.min.x)),
                                std::abs(from_middle.z) / (0.5 * (box.max.z - box.min.z)));
    EXPECT_NEAR(out, 1, 1e-9) << "on the outline of the box";
  }
}

TEST(Crash, releases_only_breakable_parts_near_the_impact) {
  size_t total_released = 0;
  for (uint64_t seed = 1; seed <= runs(30); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    test::LoneVehicle lone;
    const Vec3 at(random.uniform(-1, 1), random.uniform(0, 1.5), random.uniform(-2, 2));
    const double change = random.uniform(kCrash, 25);
    const Joints before = lone.world.joints();
    const bool any = release_joints_near(lone.world, lone.vehicle, at, change);
    const Joints& after = lone.world.joints();
    double nearest_left = 1e9, farthest_released = 0;
    size_t own = 0, released = 0;
    for (size_t j = 0; j < before.all.size(); ++j) {
      const bool of_chassis = before.all[j].body == lone.vehicle.chassis;
      const bool breaks = of_chassis && lone.vehicle.model->breaks[own++];
      const bool is_released = after.all[j].sides[0].faces.empty();
      released += is_released;
      EXPECT_TRUE(breaks || !is_released) << "joint " << j;
      const double distance = glm::distance(before.all[j].anchor, at);
      if (is_released) farthest_released = std::max(farthest_released, distance);
      if (breaks && !is_released) nearest_left = std::min(nearest_left, distance);
    }
    EXPECT_EQ(any, released > 0);
    EXPECT_EQ(joints_requested(lone.world), any);
    EXPECT_LE(farthest_released, nearest_left);
    total_released += released;
  }
  EXPECT_GT(7 * total_released, 10 * runs(30));  // over 10 in the usual seven runs
}

TEST(Crash, never_breaks_off_vital_parts_axles_or_the_laser) {
  const VehicleModel& model = *test::hatchback();
  ASSERT_EQ(model.breaks.size(), model.chassis.joints.size());
  const auto part_at = [&](const Joint& joint, size_t side) {
    const uint32_t face = joint.sides[side].faces.front();
    for (const MeshPart& part : model.chassis.body.named_parts) {
      if (face >= part.first && face < part.last) return part.name;
    }
    return std::string();
  };
  size_t breaking = 0;
  for (size_t j = 0; j < model.breaks.size(); ++j) {
    if (!model.breaks[j]) continue;
    ++breaking;
    for (const size_t side : {size_t{0}, size_t{1}}) {
      for (const char* kept : {"engine", "seat_driver", "axle", "mount"})
        EXPECT_FALSE(part_at(model.chassis.joints[j], side).starts_with(kept)) << "joint " << j;
    }
  }
  EXPECT_GT(breaking, 10u);
}

}  // namespace
}  // namespace kerf
