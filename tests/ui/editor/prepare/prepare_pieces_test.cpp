#include "ui/editor/prepare/prepare_panel.h"

#include <gtest/gtest.h>

#include "core/world/world.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

using Tool = Preparation::Tool;

// A sphere of 1 120 faces and one of 264.
World two_spheres() {
  World world;
  world.add(make_body("large", build(sphere(20, 30, 1))));
  world.add(make_body("small", build(moved(sphere(12, 12, 1), {3, 0, 0}, 1))));
  return world;
}

size_t faces_of(const World& world, size_t body) { return world.body(world.ids()[body]).mesh.live_faces(); }

TEST(PreparePieces, are_the_selected_ones_or_all) {
  const World world = two_spheres();
  PieceMap looks;
  EXPECT_EQ(pieces_to_prepare(world, looks).size(), 2u);
  looks[{world.ids()[1], 0}].selected = true;
  const auto selected = pieces_to_prepare(world, looks);
  ASSERT_EQ(selected.size(), 1u);
  EXPECT_EQ(selected[0].id.body, world.ids()[1]);
}

TEST(PreparePieces, face_counts_match_the_forecast) {
  const World world = two_spheres();
  const auto pieces = pieces_to_prepare(world, {});
  const size_t before = faces_of(world, 0) + faces_of(world, 1);
  const std::pair<Preparation, size_t> cases[]{
      {{.tool = Tool::kSimplifyToFaces, .faces = 500}, 500},
      {{.tool = Tool::kSubdivide, .scheme = Subdivision::kLoop}, 4 * before},
      {{.tool = Tool::kSubdivide, .scheme = Subdivision::kSqrt3, .times = 2}, 9 * before},
      {{.tool = Tool::kTurnShells}, before},
      {{.tool = Tool::kSmooth, .times = 3}, before}};
  for (const auto& [preparation, after] : cases) {
    EXPECT_EQ(forecast(pieces, preparation).before, before);
    ASSERT_EQ(forecast(pieces, preparation).after, after);
    Document document(world);
    ASSERT_TRUE(prepare_pieces(document, pieces, preparation, nullptr).ok());
    EXPECT_LE(document.world().live_faces(), after);
    EXPECT_GE(document.world().live_faces(), after - 4);
  }
  EXPECT_FALSE(forecast(pieces, {.tool = Tool::kSimplifyToError, .error = 0.1}).after.has_value());
}

TEST(PreparePieces, divide_the_face_count_in_proportion) {
  const World world = two_spheres();
  Document document(world);
  const Preparation half{.tool = Tool::kSimplifyToFaces, .faces = world.live_faces() / 2};
  ASSERT_TRUE(prepare_pieces(document, pieces_to_prepare(world, {}), half, nullptr).ok());
  for (size_t body = 0; body < 2; ++body)
    EXPECT_NEAR(static_cast<double>(faces_of(document.world(), body)),
                0.5 * static_cast<double>(faces_of(world, body)), 3);
}

TEST(PreparePieces, are_unchanged_when_cancelled) {
  const World world = two_spheres();
  const Preparation preparation{.tool = Tool::kSubdivide, .times = 2};
  const auto pieces = pieces_to_prepare(world, {});
  int reports = 0;
  double last = 0;
  const Progress counted{[&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return ++reports > 0;
  }};
  Document whole(world);
  ASSERT_TRUE(prepare_pieces(whole, pieces, preparation, &counted).ok());
  for (int most = 0; most < reports; most += reports / 10 + 1) {
    Document document(world);
    int calls = 0;
    const Progress stop{[&](double) { return calls++ < most; }};
    const Outcome outcome = prepare_pieces(document, pieces, preparation, &stop);
    ASSERT_FALSE(outcome.ok());
    EXPECT_EQ(outcome.error().message, "Stopped; nothing was changed.");
    EXPECT_EQ(state_hash(document.world()), state_hash(world));
    EXPECT_EQ(document.world().ids(), world.ids());
    EXPECT_EQ(document.history().size(), 0u) << "nothing to redo";
    EXPECT_TRUE(document.journal().empty());
  }
}

TEST(PreparePieces, report_why_they_cannot_be_prepared) {
  const World world = two_spheres();
  const auto pieces = pieces_to_prepare(world, {});
  EXPECT_NE(prepare_disabled_reason({}, {}), nullptr);
  EXPECT_NE(prepare_disabled_reason(pieces, {.faces = world.live_faces()}), nullptr);
  EXPECT_EQ(prepare_disabled_reason(pieces, {.faces = world.live_faces() - 1}), nullptr);
  EXPECT_NE(prepare_disabled_reason(pieces, {.tool = Tool::kSubdivide, .times = 9}), nullptr);
}

}  // namespace
}  // namespace kerf::test
