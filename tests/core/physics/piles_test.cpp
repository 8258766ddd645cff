#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/ids.h"
#include "core/physics/physics.h"
#include "tests/support/piles.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"

namespace kerf {
namespace {

std::set<std::pair<BodyId, BodyId>> intersecting_pairs(const World& world) {
  std::set<std::pair<BodyId, BodyId>> pairs;
  const std::vector<BodyId> ids = world.ids();
  for (size_t i = 0; i < ids.size(); ++i) {
    for (size_t j = i + 1; j < ids.size(); ++j) {
      if (test::intersect(world.body(ids[i]), world.body(ids[j]))) pairs.insert({ids[i], ids[j]});
    }
  }
  return pairs;
}

double max_speed(const World& world) {
  double most = 0;
  for (BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const Vec3 centre = body.placement.to_world(rigid_frame(body).centre);
    const double speed = glm::length(body.motion.velocity_at(centre, body.placement));
    EXPECT_TRUE(std::isfinite(speed));
    most = std::max(most, speed);
  }
  return most;
}

TEST(Piles, of_falling_sheets_rarely_interlock) {
  size_t touching = 0, interlocked = 0;
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    World world = test::rain(25, seed, 0.3);
    const auto at_first = intersecting_pairs(world);
    Physics physics;
    for (Ticks t = 0; t < 2 * kTicksPerSecond; ++t) physics.tick(world);
    for (const PairMemory& m : world.contact_memory()) touching += m.touching && m.second.valid();
    for (const auto& pair : intersecting_pairs(world)) interlocked += !at_first.contains(pair);
  }
  EXPECT_GT(touching, 60u);
  EXPECT_LE(static_cast<double>(interlocked), 0.05 * static_cast<double>(touching));
}

double slid(double degrees) {
  World world = test::world_with_ground();
  const double angle = degrees * 3.141592653589793 / 180;
  const glm::dquat tilt(std::cos(angle / 2), 0, 0, std::sin(angle / 2));
  const BodyId slope = test::add(world, test::rectangle(6, 6, 4), {0, 3, 0}, tilt);
  world.body(slope).pinned = true;
  const Vec3 start = Vec3(0, 3, 0) + tilt * Vec3(0, 0.002, 0);
  const BodyId plate = test::add(world, test::rectangle(0.5, 0.5, 3), start, tilt);
  Physics physics;
  for (Ticks t = 0; t < kTicksPerSecond; ++t) physics.tick(world);
  return glm::length(world.body(plate).placement.position - start);
}

TEST(Piles, friction_holds_a_plate_at_29_degrees_and_lets_it_slide_at_33) {
  EXPECT_LT(slid(29), 0.01);
  EXPECT_GT(slid(33), 0.05);
}

TEST(Piles, initially_intersecting_sheets_are_not_ejected) {
  World world = test::world_with_ground();
  const glm::dquat upright = glm::normalize(glm::dquat(1, 1, 0, 0)),
                   tilted = glm::normalize(glm::dquat(1, 0, 0.3, 0.7));
  test::add(world, test::rectangle(0.6, 0.6, 6), {0, 0.5, 0});
  test::add(world, test::rectangle(0.6, 0.6, 6), {0.05, 0.5, 0.02}, upright);
  test::add(world, test::rectangle(0.6, 0.6, 6), {0.1, 0.55, 0.02}, tilted);
  Physics physics;
  const double free_fall = std::sqrt(2 * 9.81 * 0.9);
  for (Ticks t = 0; t < 2 * kTicksPerSecond; ++t) {
    physics.tick(world);
    ASSERT_LT(max_speed(world), free_fall) << t;
  }
}

// Where each point of a body that is far from its centre goes in a tick says more than its velocity, which
// does not hold what is corrected of places.
double farthest_way(const Placement& from, const Body& to) {
  double most = 0;
  for (uint32_t v = 0; v < to.mesh.vertex_slots(); ++v) {
    const Vec3 at = to.mesh.position(VertexId(v));
    most = std::max(most, glm::length(to.placement.to_world(at) - from.to_world(at)));
  }
  return most;
}

TEST(Piles, plates_created_crossing_separate_slowly_and_sleep) {
  for (const double depth : {0.01, 0.05, 0.09}) {
    SCOPED_TRACE("depth " + std::to_string(depth));
    World world;
    world.set_environment({.gravity = {0, 0, 0}, .ground = std::nullopt});
    const glm::dquat upright = glm::normalize(glm::dquat(1, 1, 0, 0));
    const BodyId flat = test::add(world, test::rectangle(0.6, 0.6, 6), {0, 0, 0});
    const BodyId other = test::add(world, test::rectangle(0.4, 0.4, 6), {0.03, 0.2 - depth, 0.02}, upright);
    ASSERT_TRUE(test::intersect(world.body(flat), world.body(other)));
    Physics physics;
    for (Ticks t = 0; t < 5 * kTicksPerSecond; ++t) {
      const Placement before[] = {world.body(flat).placement, world.body(other).placement};
      physics.tick(world);
      EXPECT_LT(max_speed(world), 0.001) << t;
      for (const BodyId id : {flat, other})
        ASSERT_LE(farthest_way(before[id == other], world.body(id)), 0.05 / kTicksPerSecond) << t;
    }
    EXPECT_FALSE(test::intersect(world.body(flat), world.body(other)));
    EXPECT_TRUE(world.body(flat).motion.asleep && world.body(other).motion.asleep);
  }
}

// The least way on which two bodies come apart, m, of many random directions: an upper bound of how deep they
// are in each other.
double depth(const Body& a, const Body& b, Random& random) {
  double least = INFINITY;
  for (int i = 0; i < 300; ++i) {
    const Vec3 way = test::random_direction(random);
    double high = -INFINITY, low = INFINITY;
    for (uint32_t f = 0; f < a.mesh.face_slots(); ++f) {
      for (const Vec3& p : a.mesh.triangle(FaceId(f)))
        high = std::max(high, glm::dot(a.placement.to_world(p), way));
    }
    for (uint32_t f = 0; f < b.mesh.face_slots(); ++f) {
      for (const Vec3& p : b.mesh.triangle(FaceId(f)))
        low = std::min(low, glm::dot(b.placement.to_world(p), way));
    }
    least = std::min(least, high - low);
  }
  return least;
}

// What is left are walls of tubes that intersect in closed curves, far from their rims, and pairs whose way
// out the ground bars.
TEST(Piles, nine_of_ten_interpenetrating_pairs_separate_in_four_seconds) {
  Random random(1);
  size_t pairs = 0, apart = 0;
  for (uint64_t seed = 1; pairs < 200; ++seed) {
    World world = test::rain(2, seed, 0.1);
    const BodyId a = world.ids()[0], b = world.ids()[1];
    for (const BodyId id : {a, b}) world.body(id).placement.position = 0.15 * test::random_direction(random);
    world.body(a).placement.position.y += 0.6;
    world.body(b).placement.position.y += 0.6;
    if (!test::intersect(world.body(a), world.body(b))) continue;
    if (depth(world.body(a), world.body(b), random) > 0.12) continue;
    ++pairs;
    test::let_move(world, 4);
    apart += test::intersect(world.body(a), world.body(b)) ? 0 : 1;
  }
  EXPECT_GE(apart, 180u) << "of " << pairs;
}

}  // namespace
}  // namespace kerf
