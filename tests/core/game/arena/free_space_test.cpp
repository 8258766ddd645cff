#include "core/game/arena/arena.h"

#include <gtest/gtest.h>

#include "tests/support/checkout.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

const Arena& yard() {
  static const Arena arena =
      std::move(*load_arena(std::move(*read_arena(test::checkout() / "assets/arenas/yard.json"))));
  return arena;
}

// A flat square of 40 m with a box that stands fast.
Arena square_with_box(const Vec3& size, const Vec3& place) {
  Arena arena;
  arena.description.size = {40, 40};
  Body& box = arena.bodies.emplace_back().body;
  box = make_body("box", test::build(test::closed_box(size)));
  box.placement.position = place;
  box.pinned = true;
  return arena;
}

TEST(FreeSpace, includes_columns_ramps_and_the_passage_under_the_bridge) {
  const FreeSpace space(yard());
  EXPECT_EQ(space.clearance(space.spot_at({6, 0, 15})), 0) << "a column";
  EXPECT_TRUE(space.has_room(space.spot_at({12, 0, 15}))) << "between two columns";
  EXPECT_TRUE(space.has_room(space.spot_at({3, 0, 0}))) << "below the bridge";
  EXPECT_NEAR(space.place_of(space.spot_at({3, 3.4, 0})).y, 3.4, 0.05) << "on the bridge";
  EXPECT_TRUE(space.has_room(space.spot_at({3, 3.4, 0})));
  EXPECT_EQ(space.clearance(space.spot_at({15, 0, 0})), 0) << "inside of a ramp";
}

TEST(FreeSpace, clearance_is_the_distance_to_fixed_obstacles) {
  const FreeSpace space(square_with_box({2, 2, 2}, {5, 1, 0}));
  const auto clearance = [&](double x) { return space.clearance(space.spot_at({x, 0, 0})); };
  EXPECT_EQ(clearance(4.2), 0);
  EXPECT_NEAR(clearance(2.5), 1.5, 0.76);
  EXPECT_EQ(clearance(-3), FreeSpace::kFar);
  EXPECT_EQ(space.clearance(space.spot_at({-19, 0, 0})), 0) << "at the edge of the arena";
}

TEST(FreeSpace, has_no_room_at_places_the_player_cannot_reach) {
  const FreeSpace space(square_with_box({1, 2, 60}, {8, 1, 0}));
  EXPECT_TRUE(space.has_room(space.spot_at({0, 0, 0})));
  EXPECT_FALSE(space.has_room(space.spot_at({13, 0, 0}))) << "behind the wall";
}

TEST(FreeSpace, extends_over_low_and_under_high_obstacles) {
  const FreeSpace above(square_with_box({4, 0.2, 4}, {5, 0.1, 0}));
  EXPECT_TRUE(above.has_room(above.spot_at({5, 0, 0})));
  const FreeSpace below(square_with_box({4, 0.2, 4}, {5, 6, 0}));
  EXPECT_TRUE(below.has_room(below.spot_at({5, 0, 0})));
}

TEST(FreeSpace, finds_the_nearest_spot_with_room) {
  const FreeSpace space(square_with_box({2, 2, 2}, {5, 1, 0}));
  const FreeSpace::Spot spot = space.with_room_near({5.4, 0, 0}, 4);
  ASSERT_LT(spot, space.spots());
  EXPECT_GT(space.place_of(spot).x, 6);
  EXPECT_NEAR(space.place_of(spot).z, 0, 0.8);
  EXPECT_EQ(space.with_room_near({5, 0, 0}, 0.5), space.spots());
}

}  // namespace
}  // namespace kerf
