#include "core/physics/contact/mating.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "core/cut/knife.h"
#include "core/physics/physics.h"
#include "core/physics/sleep.h"
#include "core/world/body_mass.h"
#include "tests/core/physics/moving_sheets.h"
#include "tests/support/piles.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

using test::let_move;
using test::world_with_ground;

// A solid cube that rests on the ground.
class RestingCube : public testing::TestWithParam<double> {
 protected:
  RestingCube() : size_(GetParam()) {
    world_ = world_with_ground();
    const BodyId cube = test::add(world_, test::closed_box(Vec3(size_)), {0, 0.5 * size_, 0});
    world_.body(cube).solid = true;
    let_move(world_, 1);
    middle_ = world_.body(cube).placement.position;
  }

  void cut(const Vec3& normal, const Vec3& through) {
    const std::vector<BodyId> ids = world_.ids();
    ASSERT_TRUE(cut_with_plane(world_, {normal, glm::dot(normal, middle_ + size_ * through)}, ids).ok());
    release();
  }
  // Cuts along points across the z axis, relative to the middle.
  void cut_along(const std::vector<Vec2>& points) {
    KnifePath path;
    for (const Vec2& p : points) path.poses.push_back({middle_ + size_ * Vec3(p.x, p.y, -2), {0, 0, 1}});
    path.range = {0, 4 * size_};
    const std::vector<BodyId> ids = world_.ids();
    ASSERT_TRUE(cut_with_path(world_, path, ids).ok());
    release();
  }

  // Returns the longest way of a corner of the pieces in 3 s [m].
  double longest_way() {
    std::map<BodyId, Placement> before;
    for (const BodyId id : world_.ids()) before[id] = world_.body(id).placement;
    double longest = 0;
    for (int i = 0; i < 30; ++i) {
      let_move(world_, 0.1);
      for (const BodyId id : world_.ids()) {
        const Body& body = world_.body(id);
        for (uint32_t v = 0; v < body.mesh.vertex_slots(); ++v) {
          const Vec3 at = body.mesh.position(VertexId(v));
          longest = std::max(longest, glm::distance(body.placement.to_world(at), before[id].to_world(at)));
        }
      }
    }
    return longest;
  }

  World world_;
  const double size_;
  Vec3 middle_{0};

 private:
  void release() {
    Delta delta;
    release_pieces(world_, 1, delta);
    forget_contacts(world_, world_.ids());
  }
};

TEST_P(RestingCube, stays_when_a_knife_cuts_it_across) {
  cut({0, 1, 0}, Vec3(0));
  ASSERT_EQ(world_.ids().size(), 2u);
  EXPECT_LT(longest_way(), 1e-4);
}

TEST_P(RestingCube, stays_when_a_knife_cuts_it_upright) {
  cut({0.6, 0, 0.8}, {0.1, 0, 0});
  ASSERT_EQ(world_.ids().size(), 2u);
  EXPECT_LT(longest_way(), 1e-4);
}

TEST_P(RestingCube, stays_when_a_knife_cuts_it_at_a_small_slope) {
  cut({0.15, 1, 0.1}, {0, 0.2, 0});
  ASSERT_EQ(world_.ids().size(), 2u);
  EXPECT_LT(longest_way(), 1e-4);
}

TEST_P(RestingCube, stays_when_knives_cut_it_into_eight) {
  cut({1, 0, 0}, Vec3(0));
  cut({0, 1, 0}, Vec3(0));
  cut({0, 0, 1}, Vec3(0));
  ASSERT_EQ(world_.ids().size(), 8u);
  EXPECT_LT(longest_way(), 1e-4);
}

TEST_P(RestingCube, stays_when_a_knife_cuts_a_step) {
  cut_along({{-2, 0.1}, {0, 0.1}, {0.2, -0.2}, {2, -0.2}});
  ASSERT_EQ(world_.ids().size(), 2u);
  EXPECT_LT(longest_way(), 1e-4);
}

// Pieces are not stuck: the upper one slides along the cut, and stays on it.
TEST_P(RestingCube, slides_apart_along_a_steep_cut) {
  cut({1, 1, 0}, {0, 0.3, 0});
  const std::vector<BodyId> ids = world_.ids();
  ASSERT_EQ(ids.size(), 2u);
  const auto upper =
      std::ranges::max_element(ids, {}, [&](BodyId id) { return rigid_frame(world_.body(id)).centre.x; });
  Body& body = world_.body(*upper);
  body.motion.velocity = {size_, -size_, 0};
  const Vec3 before = body.placement.position;
  let_move(world_, 0.1);
  const Vec3 way = body.placement.position - before;
  EXPECT_GT(way.x, 0.05 * size_);
  EXPECT_LT(std::abs(way.x + way.y), 0.003 * size_);
}

INSTANTIATE_TEST_SUITE_P(Sizes, RestingCube, testing::Values(0.1, 1.0));

TEST(Mating, labels_only_pieces_whose_walls_touch) {
  World world;
  const BodyId box = test::add(world, test::closed_box({4, 1, 1}), Vec3(0));
  world.body(box).solid = true;
  EXPECT_TRUE(mating_labels(world.body(box)).empty());
  const std::vector<BodyId> ids{box};
  for (const double x : {-1.0, 0.5}) ASSERT_TRUE(cut_with_plane(world, {{1, 0, 0}, x}, ids).ok());
  EXPECT_EQ(mating_labels(world.body(box)).size(), 3u);
  EXPECT_FALSE(wall_corners(world.body(box)).empty());
}

TEST(Mating, ends_when_a_body_becomes_a_sheet) {
  World world;
  const BodyId box = test::add(world, test::closed_box({4, 1, 1}), Vec3(0));
  world.body(box).solid = true;
  const std::vector<BodyId> ids{box};
  ASSERT_TRUE(cut_with_plane(world, {{1, 0, 0}, 0.5}, ids).ok());
  Physics physics;
  physics.tick(world);
  ASSERT_FALSE(physics.colliders().at(box).wall_corners.empty());
  make_solid(world.body(box), false);
  Delta change;
  change.mass_changed = ids;
  physics.follow(change);
  physics.tick(world);
  EXPECT_TRUE(physics.colliders().at(box).wall_corners.empty());
}

// The colliders of two sheets with the corners of walls that face each other, those of the second along +Y.
std::array<Collider, 2> colliders_with_walls(const std::vector<MovingBody>& bodies) {
  std::array<Collider, 2> colliders{*bodies[0].collider, *bodies[1].collider};
  for (const Vec3& at : {Vec3(-0.5, 0, -0.5), Vec3(-0.5, 0, 0.5), Vec3(0.5, 0, -0.5), Vec3(0.5, 0, 0.5)}) {
    colliders[0].wall_corners.push_back({at, {0, -1, 0}});
    colliders[1].wall_corners.push_back({at, {0, 1, 0}});
  }
  return colliders;
}

TEST(Mating, counts_the_first_body_as_moved_off_the_walls_of_a_turned_one) {
  const glm::dquat turned = glm::normalize(glm::dquat(1, 0.3, -0.5, 0.7));
  test::MovingSheets sheets;
  for (int i = 0; i < 2; ++i) sheets.add(test::rectangle(1, 1, 1), Vec3(0), turned);
  std::vector<MovingBody>& bodies = sheets.bodies();
  const std::array<Collider, 2> colliders = colliders_with_walls(bodies);
  for (size_t i = 0; i < 2; ++i) bodies[i].collider = &colliders[i];
  const PairGeometry pair(bodies[0], bodies[1]);
  const Vec3 off = pair.first().now.shift - bodies[0].now.shift;
  EXPECT_NEAR(glm::distance(off, turned * Vec3(0, kContactLengths.skin, 0)), 0, 1e-12);
}

TEST(Mating, of_seated_walls_forgets_points) {
  test::MovingSheets sheets;
  for (int i = 0; i < 2; ++i) sheets.add(test::rectangle(1, 1, 1), Vec3(0));
  std::vector<MovingBody>& bodies = sheets.bodies();
  const std::array<Collider, 2> colliders = colliders_with_walls(bodies);
  for (size_t i = 0; i < 2; ++i) bodies[i].collider = &colliders[i];
  PairMemory memory{bodies[0].id, bodies[1].id, {{1, {0, 1, 0}}}, {{2, {0, 1, 0}}}, {}};
  const std::vector<Contact> contacts = PairGeometry(bodies[0], bodies[1]).contacts(memory);
  ASSERT_EQ(contacts.size(), 4u);
  for (const Contact& c : contacts) {
    EXPECT_EQ(c.normal, Vec3(0, 1, 0));
    EXPECT_EQ(c.distance, 0);
  }
  EXPECT_TRUE(memory.points_of_first.empty() && memory.points_of_second.empty());
}

}  // namespace
}  // namespace kerf
