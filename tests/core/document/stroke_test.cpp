#include "core/document/beam_queue.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

BeamMove move_along_x(double from, double to) {
  return {{{from, 1, 0}, {0, -1, 0}}, {{to, 1, 0}, {0, -1, 0}}, 1};
}

void expect_same_move(const BeamMove& a, const BeamMove& b) {
  EXPECT_EQ(a.from.origin, b.from.origin);
  EXPECT_EQ(a.to.origin, b.to.origin);
  EXPECT_EQ(a.seconds, b.seconds);
}

// What a body that has moved lists of the path is in its own frame, and follows the path when that gets
// longer and when the stroke is stopped within a move.
TEST(Stroke, that_is_truncated_lists_the_same_moves_for_a_moved_body) {
  World world = world_of(grid(4, 1));
  const BodyId id = world.ids().front();
  world.body(id).placement.position = {0.25, 0, 0};
  Stroke stroke;
  stroke.path = {move_along_x(0, 1), move_along_x(1, 2)};
  stroke.swept[id] = {};
  stroke.list_path(world);
  ASSERT_EQ(stroke.swept[id].size(), 2u);
  expect_same_move(stroke.swept[id][1], move_along_x(0.75, 1.75));
  stroke.cut_back(world, 1, move_along_x(1, 1.5));
  ASSERT_EQ(stroke.path.size(), 2u);
  expect_same_move(stroke.path[1], move_along_x(1, 1.5));
  ASSERT_EQ(stroke.swept[id].size(), 2u);
  expect_same_move(stroke.swept[id][1], move_along_x(0.75, 1.25));
  stroke.cut_back(world, 1, std::nullopt);
  EXPECT_EQ(stroke.path.size(), 1u);
  EXPECT_EQ(stroke.swept[id].size(), 1u);
}

}  // namespace
}  // namespace kerf::test
