#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/base/ids.h"
#include "core/physics/physics.h"
#include "tests/support/piles.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

const glm::dquat kAlongZ(std::sqrt(0.5), std::sqrt(0.5), 0, 0);  // turns y to z

// A strip of 4 cm that is bent to a hook: up along x = 0, across to x = 0.1 at the height 0.3, and down
// again.
Soup hook() {
  constexpr std::array<Vec3, 4> kBends{Vec3(0, 0, 0), Vec3(0, 0.3, 0), Vec3(0.1, 0.3, 0), Vec3(0.1, 0.2, 0)};
  constexpr double kLength = 0.5;
  Soup soup = test::rectangle(1, 0.04, 20);
  for (Vec3& p : soup.positions) {
    double along = kLength * (p.x + 0.5);
    size_t part = 0;
    while (part + 2 < kBends.size() && along > glm::length(kBends[part + 1] - kBends[part]) + 1e-12) {
      along -= glm::length(kBends[part + 1] - kBends[part]);
      ++part;
    }
    const Vec3 way = glm::normalize(kBends[part + 1] - kBends[part]);
    p = kBends[part] + along * way + Vec3(0, 0, p.z);
  }
  return soup;
}

TEST(Shapes, a_hook_hangs_on_a_bar) {
  constexpr double kBar = 0.01, kHeight = 1;  // m, the radius of the bar and where its middle is
  World world = test::world_with_ground();
  const BodyId bar = test::add(world, test::rod(kBar, 0.6, 24), {0, kHeight, -0.1}, kAlongZ);
  world.body(bar).pinned = true;
  const BodyId hooked = test::add(world, hook(), {-0.05, kHeight + kBar + 0.01 - 0.3, 0});
  Physics physics;
  const auto bend = [&] { return world.body(hooked).placement.to_world({0.05, 0.3, 0}).y; };
  for (Ticks t = 0; t < 4 * kTicksPerSecond; ++t) {
    physics.tick(world);
    ASSERT_GT(bend(), kHeight) << t;
  }
  EXPECT_TRUE(world.body(hooked).motion.asleep);
  EXPECT_LT(bend(), kHeight + kBar + 0.06);
}

// One of the two halves of a square of 1 m on both sides of a kerf of 4 mm along a sine. The square lies in
// y = 0, or bulges as far as this.
Soup half_at_wavy_kerf(bool left, double bulge = 0) {
  Soup soup = test::rectangle(1, 1, 40);
  for (Vec3& p : soup.positions) {
    const double rim = 0.03 * std::sin(12 * p.z) + (left ? -0.002 : 0.002);
    p.x = left ? glm::mix(-0.5, rim, p.x + 0.5) : glm::mix(rim, 0.5, p.x + 0.5);
    p.y = bulge * std::cos(3 * p.x) * std::cos(2 * p.z);
  }
  return soup;
}

TEST(Shapes, halves_across_a_wavy_kerf_do_not_move_by_themselves) {
  for (const double bulge : {0.0, 0.1}) {
    SCOPED_TRACE("bulge " + std::to_string(bulge));
    World world;
    world.set_environment({.gravity = {0, 0, 0}, .ground = std::nullopt});
    const BodyId left = test::add(world, half_at_wavy_kerf(true, bulge), Vec3(0)),
                 right = test::add(world, half_at_wavy_kerf(false, bulge), Vec3(0));
    Physics physics;
    for (Ticks t = 0; t < kTicksPerSecond; ++t) {
      physics.tick(world);
      for (const BodyId id : {left, right}) {
        ASSERT_LT(glm::length(world.body(id).placement.position), 1e-9) << t;
        ASSERT_LT(glm::length(world.body(id).motion.velocity), 1e-9) << t;
      }
    }
  }
}

TEST(Shapes, halves_across_a_wavy_kerf_rest_on_the_ground) {
  World world = test::world_with_ground();
  const BodyId left = test::add(world, half_at_wavy_kerf(true), {0, 0.002, 0}),
               right = test::add(world, half_at_wavy_kerf(false), {0, 0.002, 0});
  Physics physics;
  for (Ticks t = 0; t < 2 * kTicksPerSecond; ++t) {
    physics.tick(world);
    for (const BodyId id : {left, right}) {
      const Vec3 at = world.body(id).placement.position;
      ASSERT_LT(glm::length(Vec3(at.x, 0, at.z)), 2e-4) << t;
    }
  }
  EXPECT_TRUE(world.body(left).motion.asleep && world.body(right).motion.asleep);
}

}  // namespace
}  // namespace kerf
