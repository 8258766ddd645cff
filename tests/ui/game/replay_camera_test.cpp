#include "ui/game/game_camera.h"

#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "tests/support/checkout.h"
#include "tests/support/game_files.h"
#include "tests/support/runs.h"
#include "tests/support/segment_faces.h"

namespace kerf {
namespace {

// Whether a large body of the arena crosses the way between two points (m).
bool is_crossed(const Match& match, const Vec3& from, const Vec3& to) {
  for (const BodyId id : match.world().ids()) {
    const Body& body = match.world().body(id);
    const Bounds box = body.bounds();
    const bool large = match.is_wall(id) || glm::length(box.max - box.min) > 2;
    if (!large || match.vehicle_of(id) != Event::kNobody) continue;
    if (test::crosses(body, from, to)) return true;
  }
  return false;
}

// Two vehicles at random free places of the yard, near walls, containers and columns.
TEST(ReplayCamera, stays_in_front_of_walls_and_containers) {
  const auto rules = load_rules(test::checkout() / "assets/games/standard.json");
  ASSERT_TRUE(rules) << rules.error().message;
  Match match({*rules, 1, Difficulty::kNormal});
  auto& world = const_cast<World&>(match.world());
  const FreeSpace space((*rules)->arena);
  Random random(11);
  for (uint64_t place = 0; place < runs(80); ++place) {
    const Vec3 about(random.uniform(-36, 36), 0, random.uniform(-36, 36));
    const FreeSpace::Spot spot = space.with_room_near(about, 10);
    if (spot == space.spots()) continue;
    const Vec3 first = space.place_of(spot);
    const FreeSpace::Spot beside =
        space.with_room_near(first + 6.0 * direction_of(random.uniform(-3, 3), 0), 4);
    if (beside == space.spots()) continue;
    const Vec3 second = space.place_of(beside);
    world.body(match.vehicles()[0].chassis).placement.position = first;
    world.body(match.vehicles()[1].chassis).placement.position = second;
    ReplayCamera camera(1);
    for (int frame = 0; frame < 20; ++frame) camera.follow(match, 0.1);
    const CameraView view = camera.view(1.6, 50);
    const Vec3 watched = match.world().body(match.vehicles()[1].chassis).placement.to_world({0, 0.8, 0});
    EXPECT_FALSE(is_crossed(match, watched, camera.eye()))
        << "place " << place << ": " << first.x << ", " << first.z << " and " << second.x << ", " << second.z;
    EXPECT_EQ(view.eye, camera.eye());
  }
}

TEST(ReplayCamera, films_the_player_alone_until_the_other_vehicle_spawns) {
  const Match match({test::flat_rules(0, 0), 1, Difficulty::kNormal});
  ReplayCamera camera(match.vehicles().size());
  for (int frame = 0; frame < 20; ++frame) camera.follow(match, 0.1);
  const Vec3 car = match.world().body(match.vehicles()[Match::kPlayer].chassis).placement.position;
  EXPECT_LT(glm::length(camera.eye() - car), 20);
}

}  // namespace
}  // namespace kerf
