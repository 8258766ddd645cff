#include "core/cut/cut_step.h"

#include <gtest/gtest.h>

#include "tests/support/jointed.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// A sheet and a small one above it, which is welded to it where the beam goes.
World welded_sheets() {
  const std::vector<test::NamedSheet> sheets{{"sheet", test::rectangle(1, 0.4, 20)},
                                             {"small", test::rectangle(0.06, 0.06, 2), {0.3, 0.02, 0}}};
  JointDescription weld;
  weld.parts = {"small", "sheet"};
  weld.anchor = {0.3, 0.02, 0};
  weld.radius = 0.05;
  return test::jointed_world(sheets, {&weld, 1});
}

// From between both sheets, so that what the weld lies on in the large one burns.
const BeamMove kBurn{{{0.3, 0.01, -0.02}, {0, -1, 0}}, {{0.3, 0.01, 0.02}, {0, -1, 0}}, 0.1};

CutSettings narrow() {
  CutSettings settings;
  settings.laser.radius = 0.08;
  settings.laser.range = {0, 0.5};
  settings.resolution.target_edge = 0.01;
  return settings;
}

TEST(CutApart, leaves_parts_released_by_joints_to_the_next_search) {
  for (const bool holds : {true, false}) {
    World world = welded_sheets();
    ASSERT_EQ(world.live_pieces(), 1u);
    const BodyId body = world.ids().front();
    const auto done = holds ? cut_body(world, narrow(), body, {&kBurn, 1}, nullptr)
                            : cut_without_separation(world, narrow(), body, {&kBurn, 1});
    ASSERT_TRUE(done.ok());
    EXPECT_GT(done->delta.removed_faces, 0u);
    EXPECT_EQ(world.live_pieces(), holds ? 2u : 1u);
    continue_separation(world, 100'000);
    EXPECT_EQ(world.live_pieces(), 2u);
  }
}

}  // namespace
}  // namespace kerf
