#include <gtest/gtest.h>

#include "core/document/document.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

CutSettings narrow_beam() {
  CutSettings s;
  s.laser.radius = 0.01;
  s.resolution.target_edge = 0.02;
  return s;
}

// A pinned plate of many faces below one of few.
World two_plates() {
  World world;
  add(world, rectangle(1, 1, 120), {0, 0.5, 0});
  add(world, rectangle(1, 1, 8), {0, 0.8, 0});
  world.body(world.ids()[0]).pinned = true;
  world.set_environment({.gravity = {0, -9.81, 0}, .ground = 0});
  return world;
}

// A beam moves over both plates.
TEST(LargeBodies, keep_colliders_while_under_a_beam_and_replay_identically) {
  Document document(two_plates());
  const BodyId large = document.world().ids()[0];
  ASSERT_GT(document.world().body(large).mesh.live_faces(), Physics::kMaxUnderBeam);
  size_t large_colliders = 0;
  const auto pass = [&](Ticks ticks) {
    for (Ticks t = 0; t < ticks; ++t) {
      document.apply(AdvanceTime{1, true});
      while (document.waiting() > 0) {
        large_colliders += document.queue().next_prepared_faces() > Physics::kMaxUnderBeam;
        ASSERT_TRUE(document.step(64).ok());
      }
    }
  };
  document.apply(Play{});
  pass(40);
  EXPECT_EQ(large_colliders, 1u);
  const Vec3 down(0, -1, 0);
  document.apply(BeginStroke{narrow_beam(), {{-0.3, 3, 0}, down}});
  for (int i = 0; i < 10; ++i) {
    document.apply(MoveBeam{{{-0.28 + 0.02 * i, 3, 0}, down}});
    pass(1);
  }
  EXPECT_EQ(large_colliders, 2u) << "one where the step begins, none while it is cut";
  document.apply(EndStroke{});
  pass(30);
  EXPECT_EQ(large_colliders, 3u);
  const uint64_t hash = state_hash(document.world());
  Document again(two_plates());
  for (const Command& c : document.journal()) {
    ASSERT_TRUE(again.apply(c).ok());
    again.seal_journal();
  }
  ASSERT_TRUE(run_all(again).ok());
  EXPECT_EQ(state_hash(again.world()), hash);
  ASSERT_TRUE(document.apply(Undo{}).ok());
  document.set_window(0);
  ASSERT_TRUE(document.apply(Redo{}).ok());
  ASSERT_TRUE(run_all(document).ok());
  EXPECT_EQ(state_hash(document.world()), hash);
}

TEST(LargeBodies, keep_colliders_when_a_later_step_is_undone_before_it_begins) {
  Document document(two_plates());
  const Vec3 down(0, -1, 0);
  document.apply(BeginStroke{narrow_beam(), {{-0.3, 3, 0}, down}});
  document.apply(AdvanceTime{1, true});
  document.apply(MoveBeam{{{-0.2, 3, 0}, down}});
  document.apply(AdvanceTime{60, true});
  while (document.waiting() > 50 || document.queue().next_searches()) ASSERT_TRUE(document.step(64).ok());
  ASSERT_LE(document.queue().next_prepared_faces(), Physics::kMaxUnderBeam);
  document.apply(Play{});
  ASSERT_TRUE(document.apply(Undo{}).ok());
  ASSERT_GT(document.waiting(), 0u);
  EXPECT_LE(document.queue().next_prepared_faces(), Physics::kMaxUnderBeam);
}

}  // namespace
}  // namespace kerf::test
