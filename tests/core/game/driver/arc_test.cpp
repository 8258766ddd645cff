#include "core/game/driver/steering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/game/vehicle/vehicle_dynamics.h"

namespace kerf {
namespace {

const FreeSpace kOpen{};  // without spots: there is room everywhere

Course moving(double speed) {
  Course course;
  course.speed = speed;
  return course;
}

ArcEnd follow(double speed, const Arc& arc, std::vector<Disc> traffic = {}) {
  return follow_arc(kOpen, traffic, moving(speed), arc);
}

TEST(Arc, without_steering_continues_straight) {
  const ArcEnd end = follow(10, {0, 10});
  EXPECT_NEAR(end.at.z, 10 * kArcTime, 1e-9);
  EXPECT_EQ(end.at.x, 0);
  EXPECT_EQ(end.heading, 0);
  EXPECT_EQ(end.free_s, kArcTime);
  EXPECT_NEAR(end.free_m, end.at.z, 1e-9);
}

TEST(Arc, accelerates_and_brakes_like_a_vehicle) {
  EXPECT_NEAR(follow(0, {0, 15}).at.z, 0.5 * 4 * kArcTime * kArcTime, 0.6);
  const double stop = 12.0 * 12.0 / (2 * 7);
  EXPECT_NEAR(follow(12, {0, 0}).at.z, stop, 1);
  EXPECT_LT(follow(0, {0, -4}).at.z, -2);
}

TEST(Arc, left_mirrors_right) {
  const ArcEnd left = follow(6, {1, 6}), right = follow(6, {-1, 6});
  EXPECT_GT(left.at.x, 1);
  EXPECT_GT(left.heading, 0.5);
  EXPECT_NEAR(left.at.x, -right.at.x, 1e-9);
  EXPECT_NEAR(left.at.z, right.at.z, 1e-9);
  EXPECT_NEAR(left.heading, -right.heading, 1e-9);
}

// The rear axle of the bicycle: a radius of wheelbase / tan(lock), as long as the tyres hold.
TEST(Arc, turns_on_the_circle_of_the_bicycle_model) {
  constexpr double kSpeed = 3;
  const double radius = moving(0).wheelbase / std::tan(full_lock(kSpeed));
  EXPECT_NEAR(follow(kSpeed, {1, kSpeed}).heading, kSpeed * kArcTime / radius, 0.01);
}

TEST(Arc, ends_before_an_obstacle) {
  const Disc wreck{{0, 0, 12}, 1, Vec3(0), BodyId{}};
  const ArcEnd end = follow(10, {0, 10}, {wreck});
  EXPECT_LT(end.free_s, kArcTime);
  EXPECT_GT(end.free_m, 6);
  EXPECT_LT(end.at.z + moving(0).reach, 12 - 1);
  EXPECT_EQ(follow(10, {0, 10}, {{{6, 0, 12}, 1, Vec3(0), BodyId{}}}).free_s, kArcTime) << "beside the way";
  EXPECT_EQ(follow(10, {0, 10}, {{{0, 5, 12}, 1, Vec3(0), BodyId{}}}).free_s, kArcTime) << "on another floor";
}

TEST(Arc, avoids_predicted_traffic) {
  EXPECT_EQ(follow(10, {0, 10}, {{{0, 0, 12}, 1, {0, 0, 12}, BodyId{}}}).free_s, kArcTime)
      << "it drives ahead";
  EXPECT_LT(follow(10, {0, 10}, {{{9, 0, 12}, 1, {-8, 0, 0}, BodyId{}}}).free_s, kArcTime) << "it crosses";
}

TEST(Arc, leads_out_of_an_obstacle_it_overlaps) {
  const Disc wreck{{0, 0, -1.5}, 1, Vec3(0), BodyId{}};
  EXPECT_EQ(follow(0, {0, 6}, {wreck}).free_s, kArcTime);
  EXPECT_LT(follow(0, {0, -6}, {wreck}).free_s, kArcTime) << "deeper";
}

}  // namespace
}  // namespace kerf
