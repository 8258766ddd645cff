#include "core/game/match/cut_motion.h"

#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "core/game/match/rules.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

// The wheel of a car that stands alone, and its chassis.
class CutMotion : public testing::Test {
 protected:
  Body& wheel() { return stage_.world.body(stage_.vehicle.wheels[0].body); }
  Body& chassis() { return stage_.world.body(stage_.vehicle.chassis); }
  static Vec3 velocity_of_centre(const Body& body) {
    return body.motion.velocity_at(middle_of(body), body.placement);
  }

  test::LoneVehicle stage_;
};

// The beam points ahead and sweeps down, so that the cut is a plane along the car.
TEST_F(CutMotion, a_light_part_moves_across_the_cut_and_along_the_stroke_and_turns) {
  CutTrails trails;
  for (int i = 0; i < 5; ++i) trails.record(stage_.vehicle.chassis, {0, 1 - 0.01 * i, 0}, {0, 0, 1});
  const Vec3 before = velocity_of_centre(wheel());
  const Vec3 across = part_at_cut(chassis(), wheel(), trails.of(stage_.vehicle.chassis), true);
  const Vec3 change = velocity_of_centre(wheel()) - before;
  EXPECT_NEAR(std::abs(across.x), 1, 1e-9);
  EXPECT_NEAR(glm::dot(change, across), 0.8, 1e-9);
  EXPECT_NEAR(change.y, -0.4, 1e-9);
  EXPECT_NEAR(glm::length(wheel().motion.spin), 1.5, 1e-9);
  EXPECT_GT(glm::dot(across, wheel().placement.position - chassis().placement.position + across), 0);
  EXPECT_EQ(chassis().motion.velocity, Vec3(0)) << "a car is too heavy to be moved";
}

TEST_F(CutMotion, the_other_half_moves_the_opposite_way_if_it_is_light) {
  Body& other = stage_.world.body(stage_.vehicle.wheels[1].body);
  const Vec3 before = velocity_of_centre(other);
  const Vec3 across = part_at_cut(other, wheel(), nullptr, true);
  EXPECT_NEAR(glm::dot(velocity_of_centre(other) - before, across), -0.8, 1e-9);
  const Vec3 unmoved = velocity_of_centre(wheel());
  part_at_cut(wheel(), other, nullptr, false);
  EXPECT_EQ(velocity_of_centre(wheel()), unmoved);
}

TEST_F(CutMotion, a_heavy_part_only_tips_over) {
  CutTrails trails;
  for (int i = 0; i < 5; ++i) trails.record(stage_.vehicle.wheels[0].body, {0.01 * i, 1, 0}, {0, 0, 1});
  chassis().motion = Motion{};
  part_at_cut(wheel(), chassis(), trails.of(stage_.vehicle.wheels[0].body), true);
  EXPECT_NEAR(velocity_of_centre(chassis()).y, 0, 1e-9) << "it is not lifted";
  EXPECT_NEAR(velocity_of_centre(chassis()).x, 0.8, 1e-9);
}

// A car is more than twice as long as wide.
TEST_F(CutMotion, a_long_heavy_prop_topples_at_right_angles_to_its_length_unless_it_lies_on_its_side) {
  CutTrails trails;
  for (int i = 0; i < 5; ++i) trails.record(stage_.vehicle.chassis, {0, 0, 0.01 * i}, {1, 0, 0});
  const CutTrail* trail = trails.of(stage_.vehicle.chassis);
  wheel().placement.position.y = -5;
  chassis().motion = Motion{};
  topple(wheel(), chassis(), trail);
  EXPECT_LT(glm::distance(chassis().motion.spin, Vec3(0, 0, -1)), 1e-9)
      << "the top moves along the beam, to +X";
  chassis().placement.orientation = glm::angleAxis(kPi / 2, Vec3(0, 0, 1));
  chassis().motion = Motion{};
  topple(wheel(), chassis(), trail);
  EXPECT_NEAR(glm::length(chassis().motion.spin), 0.5, 1e-9);
}

TEST_F(CutMotion, a_chip_above_the_foot_of_a_prop_does_not_topple_it) {
  CutTrails trails;
  for (int i = 0; i < 5; ++i) trails.record(stage_.vehicle.chassis, {0, 0, 0.01 * i}, {1, 0, 0});
  const CutTrail* trail = trails.of(stage_.vehicle.chassis);
  chassis().motion = Motion{};
  wheel().placement.position.y += middle_of(chassis()).y - 0.05 - middle_of(wheel()).y;
  topple(chassis(), wheel(), trail);
  EXPECT_EQ(chassis().motion.spin, Vec3(0));
  wheel().placement.position.y -= 5;
  topple(chassis(), wheel(), trail);
  EXPECT_LT(glm::distance(chassis().motion.spin, Vec3(0, 0, -1)), 1e-9) << "it stood on the part";
  chassis().motion.spin *= 0.9;
  chassis().motion.velocity.y = -1;
  topple(chassis(), wheel(), trail);
  EXPECT_EQ(chassis().motion.velocity.y, -1) << "it falls already";
}

TEST_F(CutMotion, a_wheel_pops_off_at_two_metres_a_second) {
  const Vec3 before = velocity_of_centre(wheel());
  pop_off(wheel(), {1, 0, 0}, nullptr);
  const Vec3 change = velocity_of_centre(wheel()) - before;
  EXPECT_NEAR(glm::length(change), 2, 1e-9);
  EXPECT_GT(change.x, 1.5);
  EXPECT_FALSE(wheel().motion.asleep);
}

}  // namespace
}  // namespace kerf
