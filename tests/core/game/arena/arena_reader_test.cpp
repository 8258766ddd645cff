#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "core/game/arena/arena.h"
#include "tests/support/changed_text.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

TEST(ArenaFile, start_positions_must_be_inside) {
  test::TemporaryFolder folder;
  const auto file = folder / "arena.json";
  test::write_text(file, R"({"size": [50, 50], "starts": {"player": {"position": [0, 0, 26]},
    "enemies": [{"position": [0, 0, 1]}]}})");
  const auto arena = read_arena(file);
  ASSERT_FALSE(arena);
  EXPECT_NE(arena.error().message.find("/starts: a start is outside"), std::string::npos)
      << arena.error().message;
}

TEST(ArenaFile, places_bodies_by_pose_or_heading) {
  test::TemporaryFolder folder;
  const auto file = folder / "arena.json";
  test::write_text(file, R"({"ground": 2, "size": [50, 40],
    "bodies": [{"mesh": "a.obj", "position": [1, 2, 3], "heading": 90},
               {"mesh": "b.obj", "pose": {"position": [4, 5, 6], "heading": -90}, "cuttable": true}],
    "starts": {"player": {"position": [0, 0, 19], "heading": 180}, "enemies": [{"position": [0, 0, 1]}]}})");
  const auto arena = read_arena(file);
  ASSERT_TRUE(arena) << arena.error().message;
  EXPECT_EQ(arena->name, "arena");
  EXPECT_EQ(arena->ground, 2);
  ASSERT_EQ(arena->bodies.size(), 2u);
  const Placement &a = arena->bodies[0].body.placement, &b = arena->bodies[1].body.placement;
  EXPECT_EQ(a.position, Vec3(1, 2, 3));
  EXPECT_EQ(b.position, Vec3(4, 5, 6));
  EXPECT_NEAR((a.orientation * Vec3(0, 0, 1)).x, 1, 1e-12);
  EXPECT_NEAR((b.orientation * Vec3(0, 0, 1)).x, -1, 1e-12);
  EXPECT_FALSE(arena->bodies[0].cuttable);
  EXPECT_TRUE(arena->bodies[1].cuttable);
  EXPECT_EQ(arena->bodies[0].body.mesh, folder / "a.obj");
  EXPECT_NEAR(arena->player.heading, kPi, 1e-12);
}

TEST(ArenaFile, names_the_first_error) {
  const std::string good = R"({"size": [50, 50], "bodies": [{"mesh": "a.obj"}],
    "starts": {"player": {"position": [0, 0, 0]}, "enemies": [{"position": [0, 0, 1]}]}})";
  test::TemporaryFolder folder;
  const auto file = folder / "arena.json";
  for (const test::Wrong& w :
       {test::Wrong{"[50, 50]", "[50]", "/size: must be two numbers"},
        test::Wrong{"[50, 50]", "[5, 50]", "/size: must be from 10"},
        test::Wrong{"\"mesh\": \"a.obj\"", "", "/bodies/0"},
        test::Wrong{"[{\"position\": [0, 0, 1]}]", "[]", "/starts/enemies: must contain at least one"},
        test::Wrong{"\"player\"", "\"nobody\"", "needs \"player\""},
        test::Wrong{"[0, 0, 0]}", "[0, 0, 0], \"heading\": 400}", "/starts/player/heading"}}) {
    test::write_text(file, test::with(good, w.part, w.other));
    const auto bad = read_arena(file);
    ASSERT_FALSE(bad) << w.expected;
    EXPECT_NE(bad.error().message.find(w.expected), std::string::npos) << bad.error().message;
  }
}

}  // namespace
}  // namespace kerf
