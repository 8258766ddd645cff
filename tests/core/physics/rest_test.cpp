#include <gtest/gtest.h>

#include <cmath>

#include "core/base/ids.h"
#include "core/base/random.h"
#include "core/physics/physics.h"
#include "tests/support/piles.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

using test::let_move;
using test::world_with_ground;

glm::dquat random_turn(Random& random) {
  double c[4];
  for (double& x : c) x = random.uniform(-1, 1);
  return glm::normalize(glm::dquat(c[0], c[1], c[2], c[3]));
}

// Whether all vertices of a body are above a height.
bool is_above(const Body& body, double height) {
  for (uint32_t v = 0; v < body.mesh.vertex_slots(); ++v) {
    if (body.placement.to_world(body.mesh.position(VertexId(v))).y < height) return false;
  }
  return true;
}

TEST(Rest, a_leaning_plate_stays_in_place) {
  World world = world_with_ground();
  const glm::dquat upright(std::sqrt(0.5), std::sqrt(0.5), 0, 0);  // turns y = 0 to z = 0
  const BodyId wall = test::add(world, test::rectangle(2, 2, 4), {0, 1, 0}, upright);
  world.body(wall).pinned = true;
  const double lean = 0.3;  // from the wall
  const glm::dquat tilted(std::cos(0.785398163 - lean / 2), std::sin(0.785398163 - lean / 2), 0, 0);
  const Vec3 middle(0, 0.25 * std::cos(lean) + 0.002, 0.25 * std::sin(lean) + 0.004);
  const BodyId plate = test::add(world, test::rectangle(0.5, 0.5, 4), middle, tilted);
  let_move(world, 3);
  EXPECT_TRUE(world.body(plate).motion.asleep);
  EXPECT_LT(glm::length(world.body(plate).placement.position - middle), 0.03);
}

TEST(Rest, a_stack_that_may_not_sleep_hardly_jitters) {
  World world = world_with_ground();
  for (int i = 0; i < 5; ++i) test::add(world, test::rectangle(0.8, 0.8, 3), {0, 0.003 * (i + 1), 0});
  Physics physics;
  double sum = 0, count = 0;
  for (Ticks t = 0; t < 4 * kTicksPerSecond; ++t) {
    physics.tick(world);
    for (const BodyId id : world.ids()) {
      Body& body = world.body(id);
      body.motion.asleep = false;
      body.motion.quiet = 0;
      if (t < 2 * kTicksPerSecond) continue;
      const Vec3 centre = body.placement.to_world(rigid_frame(body).centre);
      const Vec3 velocity = body.motion.velocity_at(centre, body.placement);
      sum += glm::dot(velocity, velocity);
      ++count;
    }
  }
  EXPECT_LT(std::sqrt(sum / count), 0.001);
}

TEST(Rest, a_rattling_piece_does_not_keep_distant_bodies_awake) {
  World world = world_with_ground();
  std::vector<BodyId> row;  // of plates that overlap like tiles
  for (int i = 0; i < 6; ++i) {
    const glm::dquat tilt = glm::normalize(glm::dquat(1, 0, 0, 0.02));
    row.push_back(test::add(world, test::rectangle(0.4, 0.4, 3), {0.3 * i, 0.01, 0}, tilt));
  }
  Physics physics;
  for (Ticks t = 0; t < 4 * kTicksPerSecond; ++t) {
    physics.tick(world);
    world.body(row.front()).motion.quiet = 0;
    world.body(row.front()).motion.asleep = false;
  }
  EXPECT_FALSE(world.body(row.front()).motion.asleep);
  EXPECT_TRUE(world.body(row.back()).motion.asleep);
}

TEST(Rest, nothing_passes_the_ground_at_any_speed) {
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    for (const double speed : {30.0, 80.0}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " at " + std::to_string(speed) + " m/s");
      Random random(seed);
      World world = world_with_ground();
      const BodyId plate = test::add(world, test::rectangle(0.4, 0.3, 4), {0, 2, 0}, random_turn(random));
      world.body(plate).motion.velocity = {random.uniform(-3, 3), -speed, random.uniform(-3, 3)};
      Physics physics;
      for (int t = 0; t < 36; ++t) {
        physics.tick(world);
        ASSERT_GT(world.body(plate).placement.position.y, 0) << t;
      }
    }
  }
}

TEST(Rest, nothing_passes_a_free_sheet_at_any_speed) {
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    for (const double speed : {30.0, 80.0}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " at " + std::to_string(speed) + " m/s");
      Random random(seed);
      World world;
      world.set_environment({.gravity = {0, 0, 0}, .ground = std::nullopt});
      const BodyId sheet = test::add(world, test::rectangle(3, 3, 6), {0, 0, 0});
      const BodyId plate = test::add(world, test::rectangle(0.3, 0.2, 4), {0, 1, 0}, random_turn(random));
      world.body(plate).motion.velocity = {0, -speed, 0};
      Physics physics;
      for (int t = 0; t < 24; ++t) {
        physics.tick(world);
        const Vec3 at = world.body(plate).placement.position;
        ASSERT_GT(world.body(sheet).placement.to_body(at).y, 0) << t;
      }
    }
  }
}

TEST(Rest, random_falling_sheets_stay_in_the_world) {
  World world = test::rain(20, 11, 0.4);
  Physics physics;
  for (Ticks t = 0; t < 3 * kTicksPerSecond; ++t) {
    physics.tick(world);
    for (const BodyId id : world.ids()) {
      const Body& body = world.body(id);
      ASSERT_TRUE(std::isfinite(glm::length(body.placement.position) + glm::length(body.motion.spin))) << t;
      ASSERT_LT(glm::length(body.placement.position), 20) << t;
    }
  }
  for (const BodyId id : world.ids()) EXPECT_TRUE(is_above(world.body(id), -0.005));
}

}  // namespace
}  // namespace kerf
