#include "core/document/beam_queue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/deterministic_math.h"
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

// The body turns about the origin of the beam, so that the end of the beam moves the most in its frame.
TEST(Stroke, carries_the_end_of_the_beam_by_at_most_a_radius_through_a_turning_body) {
  World world = world_of(grid(4, 2));
  const BodyId id = world.ids().front();
  Body& body = world.body(id);
  const Placement before = body.placement;
  const Pose still{{0, 3, 0}, {0, -1, 0}};
  body.placement.orientation = axis_angle(Vec3(0, 0, 1), 0.04);
  body.placement.position = still.origin - body.placement.orientation * still.origin;
  Stroke stroke;
  stroke.settings.laser.radius = 0.02;
  const std::vector<BeamMove> moves = stroke.move_body(id, body, before, still);
  ASSERT_FALSE(moves.empty());
  const double reach = 3 + std::sqrt(2.0);  // through the sphere around the sheet
  const auto end = [&](const Pose& beam) { return beam.origin + reach * beam.direction; };
  for (const BeamMove& move : moves)
    EXPECT_LE(glm::distance(end(move.from), end(move.to)), stroke.settings.laser.radius);
}

}  // namespace
}  // namespace kerf::test
