#include "core/game/driver/steering.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/game/match/rules.h"
#include "tests/support/checkout.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

const Arena& yard() {
  static const Arena arena =
      std::move(*load_arena(std::move(*read_arena(test::checkout() / "assets/arenas/yard.json"))));
  return arena;
}

std::vector<FreeSpace::Spot> spots_with_room(const FreeSpace& space) {
  std::vector<FreeSpace::Spot> spots;
  for (FreeSpace::Spot spot = 0; spot < space.spots(); ++spot) {
    if (space.has_room(spot)) spots.push_back(spot);
  }
  return spots;
}

TEST(Route, connects_any_two_free_places_through_free_space) {
  const FreeSpace space(yard());
  const std::vector<FreeSpace::Spot> spots = spots_with_room(space);
  ASSERT_GT(spots.size(), 3000u);
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    const auto from = spots[random.below(spots.size())], to = spots[random.below(spots.size())];
    const std::vector<Vec3> route = find_route(space, {}, space.place_of(from), space.place_of(to));
    ASSERT_FALSE(route.empty()) << "pair " << i << " of seed 11";
    EXPECT_LT(glm::distance(route.back(), space.place_of(to)), 0.01);
    for (size_t k = 0; k < route.size(); ++k) {
      ASSERT_TRUE(space.has_room(space.spot_at(route[k]))) << "pair " << i << " of seed 11";
      if (k > 0) ASSERT_LT(glm::distance(route[k], route[k - 1]), 1.2);
    }
  }
}

TEST(Route, leads_out_of_a_blocked_place) {
  const FreeSpace space(yard());
  const std::vector<Vec3> route = find_route(space, {}, {6, 0, 15.3}, {20, 0, 15});
  ASSERT_GT(route.size(), 5u);
  EXPECT_FALSE(space.has_room(space.spot_at(route.front())));
  EXPECT_TRUE(space.has_room(space.spot_at(route[4])));
}

TEST(Route, avoids_traffic) {
  const FreeSpace space(yard());
  const Vec3 from(-34, 0, -15), to(-34, 0, 30), middle(-34, 0, -5);
  const auto nearest_to_middle = [&](const std::vector<Vec3>& route) {
    double nearest = 1e9;
    for (const Vec3& p : route) nearest = std::min(nearest, glm::distance(p, middle));
    return nearest;
  };
  const Disc wreck{middle, 1.5, Vec3(0), BodyId{}};
  EXPECT_LT(nearest_to_middle(find_route(space, {}, from, to)), 1.5);
  EXPECT_GT(nearest_to_middle(find_route(space, {&wreck, 1}, from, to)), 2);
}

}  // namespace
}  // namespace kerf
