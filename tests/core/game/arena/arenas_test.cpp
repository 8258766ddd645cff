#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/game/arena/arena.h"
#include "core/game/driver/steering.h"
#include "tests/support/checkout.h"

namespace kerf {
namespace {

const Arena& depot() {
  static const Arena arena =
      std::move(*load_arena(std::move(*read_arena(test::checkout() / "assets/arenas/depot.json"))));
  return arena;
}

// Places of the depot: on and below the galleries and the bridge, and at the foot of each ramp.
std::vector<Vec3> places() {
  std::vector<Vec3> all{{0, 3.4, 1}, {5, 0, 1}, {14, 0, 0}, {-14, 0, 0}};
  for (const double x : {-13.8, 13.8}) {
    for (const double z : {-9.0, 9.0}) all.emplace_back(x, 3.4, z);
    for (const double z : {-31.5, 31.5}) all.emplace_back(x, 0, z);
  }
  return all;
}

TEST(Depot, routes_connect_all_starts_ramps_and_the_upper_floor) {
  const FreeSpace space(depot());
  std::vector<Vec3> all = places();
  all.push_back(depot().description.player.position);
  for (const Start& start : depot().description.enemies) all.push_back(start.position);
  for (const Vec3& to : all) {
    const FreeSpace::Spot goal = space.spot_at(to);
    ASSERT_TRUE(space.has_room(goal)) << to.x << ", " << to.y << ", " << to.z;
    EXPECT_NEAR(space.place_of(goal).y, to.y, 0.1) << to.x << ", " << to.z;
    for (const Vec3& from : all) {
      const std::vector<Vec3> route = find_route(space, {}, from, to);
      ASSERT_FALSE(route.empty()) << from.x << ", " << from.z << " to " << to.x << ", " << to.z;
      EXPECT_LT(glm::distance(route.back(), space.place_of(goal)), 1.5);
    }
  }
}

TEST(Depot, has_room_at_every_start) {
  const FreeSpace space(depot());
  for (const Start& start : depot().description.enemies) {
    EXPECT_GE(space.clearance(space.spot_at(start.position)), 1.4)
        << start.position.x << ", " << start.position.z;
    for (const ModelBody& body : depot().bodies) {
      const Vec3 way = body.body.placement.position - start.position;
      if (!body.body.pinned)
        EXPECT_GT(glm::length(Vec2(way.x, way.z)), 4) << start.position.x << ", " << start.position.z;
    }
  }
}

TEST(Depot, the_way_up_leads_over_a_ramp) {
  const FreeSpace space(depot());
  const std::vector<Vec3> route = find_route(space, {}, {5, 0, 1}, {0, 3.4, 1});
  double length = 0, steepest = 0;
  for (size_t i = 1; i < route.size(); ++i) {
    length += glm::distance(route[i], route[i - 1]);
    steepest = std::max(steepest, std::abs(route[i].y - route[i - 1].y));
  }
  EXPECT_GT(length, 50);
  EXPECT_LT(steepest, 0.3);
}

// The reference samples the faces five times as finely as FreeSpace, and compares each spot with all points
// nearby.
class Reference {
 public:
  explicit Reference(const Arena& arena) : half_(0.5 * arena.description.size) {
    for (const Triangle& t : fixed_faces(arena)) {
      const double longest =
          std::max({glm::distance(t[0], t[1]), glm::distance(t[1], t[2]), glm::distance(t[2], t[0])});
      const int n = 1 + static_cast<int>(longest / kFine);
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; i + j <= n; ++j)
          add(t[0] + static_cast<double>(i) / n * (t[1] - t[0]) + static_cast<double>(j) / n * (t[2] - t[0]));
      }
    }
  }

  // Returns true if a fixed body is in the way of a vehicle within `reach` [m] of a place on a floor, or the
  // arena ends there.
  bool is_obstructed(const Vec3& place, double reach) const {
    if (std::abs(place.x) > half_.x - 3 - reach || std::abs(place.z) > half_.y - 3 - reach) return true;
    for (double dx = -reach - kCell; dx <= reach + kCell; dx += kCell) {
      for (double dz = -reach - kCell; dz <= reach + kCell; dz += kCell) {
        const auto found = points_.find(cell_of(place + Vec3(dx, 0, dz)));
        if (found == points_.end()) continue;
        for (const Vec3& p : found->second) {
          const double up = p.y - place.y;
          if (up > kBump && up < kRoof && glm::length(Vec2(p.x - place.x, p.z - place.z)) < reach)
            return true;
        }
      }
    }
    return false;
  }

 private:
  static constexpr double kFine = 0.05, kCell = 0.5;  // m
  static constexpr double kBump = 0.45, kRoof = 2.1;  // m, with a margin for slopes
  static std::pair<int, int> cell_of(const Vec3& p) {
    return {static_cast<int>(std::floor(p.x / kCell)), static_cast<int>(std::floor(p.z / kCell))};
  }
  void add(const Vec3& p) {
    if (std::abs(p.x) < half_.x && std::abs(p.z) < half_.y && p.y < 8) points_[cell_of(p)].push_back(p);
  }

  Vec2 half_;
  std::map<std::pair<int, int>, std::vector<Vec3>> points_;
};

TEST(Depot, free_space_agrees_with_a_test_of_all_faces) {
  const FreeSpace space(depot());
  const Reference reference(depot());
  size_t with_room = 0;
  for (FreeSpace::Spot spot = 0; spot < space.spots(); ++spot) {
    const Vec3 place = space.place_of(spot);
    if (space.has_room(spot)) {
      ++with_room;
      EXPECT_FALSE(reference.is_obstructed(place, 0.55)) << place.x << ", " << place.y << ", " << place.z;
    } else if (spot < space.spots() / 2) {
      // Ramps close the ground below them off from the rest.
      const bool below_ramp = std::abs(place.x) > 9 && std::abs(place.z) > 9.5 && std::abs(place.z) < 30.5;
      EXPECT_TRUE(below_ramp || reference.is_obstructed(place, 2.2))
          << place.x << ", " << place.y << ", " << place.z;
    }
  }
  EXPECT_GT(with_room, 2500u);
}

}  // namespace
}  // namespace kerf
