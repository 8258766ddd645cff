#include "core/game/arena/arena.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/deterministic_math.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

bool stops_all(BodyId) { return true; }

// A sheet of two metres at the height of 1 m, over the ground.
class SheetInRay : public testing::Test {
 protected:
  SheetInRay() {
    Environment around;
    around.ground = 0;
    world_.set_environment(around);
    sheet_ = test::add(world_, test::rectangle(2, 2, 2), {0, 1, 0});
  }
  std::optional<SightHit> look(const Vec3& from, const Vec3& direction, double length,
                               const Sight::Stops& stops = stops_all) const {
    return Sight(world_).nearest({from, glm::normalize(direction)}, length, stops);
  }

  World world_;
  BodyId sheet_;
};

TEST_F(SheetInRay, is_hit_from_either_side_with_a_normal_against_the_ray) {
  for (const double side : {1.0, -1.0}) {
    const auto hit = look({0.3, 1 + 0.5 * side, 0.2}, {0, -side, 0}, 9);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, sheet_);
    EXPECT_NEAR(hit->length, 0.5, 1e-9);
    EXPECT_NEAR(hit->normal.y, side, 1e-9);
  }
}

TEST_F(SheetInRay, passes_rays_if_filtered_out_or_hidden) {
  const auto ground = look({0, 3, 0}, {0, -1, 0}, 9, [](BodyId) { return false; });
  ASSERT_TRUE(ground);
  EXPECT_FALSE(ground->body.valid());
  EXPECT_NEAR(ground->length, 3, 1e-12);
  EXPECT_EQ(ground->normal, Vec3(0, 1, 0));
  world_.body(sheet_).hidden = true;
  EXPECT_FALSE(look({0, 3, 0}, {0, -1, 0}, 9)->body.valid());
}

TEST_F(SheetInRay, is_hit_at_its_moved_position) {
  world_.body(sheet_).placement = {{0, 0, 5}, axis_angle({1, 0, 0}, kPi / 2)};
  const auto hit = look({0, 0.5, 0}, {0, 0, 1}, 9);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->length, 5, 1e-9);
  EXPECT_NEAR(hit->normal.z, -1, 1e-9);
}

TEST_F(SheetInRay, is_not_hit_beyond_the_ray_length) {
  EXPECT_FALSE(look({0, 2, 0}, {0, -1, 0}, 0.99));
  EXPECT_TRUE(look({0, 2, 0}, {0, -1, 0}, 1.01));
  EXPECT_FALSE(look({5, 1, 0}, {1, -1, 0}, 1.41)) << "the ground is farther along a slanted ray";
  EXPECT_NEAR(look({5, 1, 0}, {1, -1, 0}, 2)->length, std::sqrt(2.0), 1e-12);
  EXPECT_FALSE(look({5, -1, 0}, {0, -1, 0}, 9)) << "below the ground";
}

TEST(Sight, a_ray_passes_near_points_at_its_side_but_not_beyond_its_ends) {
  const Pose ray{{0, 0, 0}, {0, 0, 1}};
  EXPECT_TRUE(passes_near(ray, 4, {1, 0, 2}, 1));
  EXPECT_FALSE(passes_near(ray, 4, {1.01, 0, 2}, 1));
  EXPECT_TRUE(passes_near(ray, 4, {1.01, 0, 2}, 1, 0.02));
  EXPECT_FALSE(passes_near(ray, 4, {0, 0, 5.01}, 1));
  EXPECT_FALSE(passes_near(ray, 4, {0, 0, -1.01}, 1));
  EXPECT_TRUE(passes_near(ray, 4, {0, 0, -0.99}, 1));
}

}  // namespace
}  // namespace kerf
