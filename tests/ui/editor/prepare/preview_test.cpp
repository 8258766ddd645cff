#include "ui/editor/prepare/prepare_panel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/world/world.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

using Tool = Preparation::Tool;

const Progress kGoesOn{[](double) { return true; }};

World plate_and_ball() {
  World world;
  world.add(make_body("plate", build(grid(10, 1))));
  world.add(make_body("ball", build(moved(sphere(12, 12, 1), {3, 0, 0}, 1))));
  return world;
}

// The sides of a closed surface: three for two faces.
size_t sides_of_closed(size_t faces) { return faces * 3 / 2; }

TEST(Preview, shows_the_resulting_faces_without_changing_the_world) {
  const World world = plate_and_ball();
  const uint64_t before = state_hash(world);
  std::vector<PieceRow> ball = pieces_to_prepare(world, {});
  std::erase_if(ball, [](const PieceRow& row) { return row.name != "ball"; });
  const Preparation preparation{.tool = Tool::kSubdivide, .scheme = Subdivision::kLoop, .times = 2};
  const auto preview = make_preview(world, ball, preparation, kGoesOn);
  ASSERT_TRUE(preview.ok()) << preview.error().message;
  EXPECT_EQ(state_hash(world), before);
  EXPECT_EQ(preview->before.faces, ball[0].faces);
  Document document(world);
  ASSERT_TRUE(prepare_pieces(document, ball, preparation, nullptr).ok());
  EXPECT_EQ(preview->after.faces, document.world().live_faces() - 200);
  ASSERT_EQ(preview->wire->parts.size(), 1u);
  EXPECT_EQ(preview->wire->parts[0].piece, ball[0].id);
  EXPECT_EQ(preview->wire->parts[0].edges.size(), sides_of_closed(preview->after.faces));
  EXPECT_GT(preview->distance, 0);
}

TEST(Preview, measures_the_angles_and_the_distance) {
  World world;
  world.add(make_body("plate", build(grid(10, 1))));
  const auto plate = pieces_to_prepare(world, {});
  const auto halves =
      make_preview(world, plate, {.tool = Tool::kSubdivide, .scheme = Subdivision::kMidpoint}, kGoesOn);
  ASSERT_TRUE(halves.ok());
  EXPECT_NEAR(halves->before.min_angle, 45, 1e-6);
  EXPECT_NEAR(halves->after.min_angle, 45, 1e-6);
  EXPECT_NEAR(halves->distance, 0, 1e-12);
  EXPECT_NEAR(halves->wire->parts[0].mean_edge, (2 * 0.05 + std::sqrt(2) * 0.05) / 3, 0.002);
}

// The distance is what was asked for, or less.
TEST(Preview, simplification_to_an_error_stays_within_it) {
  World world;
  world.add(make_body("ball", build(sphere(40, 40, 1))));
  const auto ball = pieces_to_prepare(world, {});
  const auto coarse = make_preview(world, ball, {.tool = Tool::kSimplifyToError, .error = 0.05}, kGoesOn);
  ASSERT_TRUE(coarse.ok());
  EXPECT_LT(coarse->after.faces, coarse->before.faces / 2);
  EXPECT_GT(coarse->distance, 0.01);
  EXPECT_LT(coarse->distance, 0.06);
}

TEST(Preview, can_be_cancelled_and_reports_if_unavailable) {
  const World world = plate_and_ball();
  const auto pieces = pieces_to_prepare(world, {});
  const Progress stop{[](double) { return false; }};
  EXPECT_FALSE(make_preview(world, pieces, {.faces = 100}, stop).ok());
  EXPECT_EQ(preview_disabled_reason(world, pieces, {.faces = 100}), nullptr);
  EXPECT_NE(preview_disabled_reason(world, pieces, {.tool = Tool::kSubdivide, .times = 7}), nullptr);
  EXPECT_NE(preview_disabled_reason(world, {}, {.faces = 100}), nullptr);
}

}  // namespace
}  // namespace kerf::test
