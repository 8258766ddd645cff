#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "tests/ui/render/shadow_scenes.h"
#include "tests/ui/render/stage.h"

namespace kerf {
namespace {

constexpr int kFollowingWidth = 120, kFollowingHeight = 90;
// Corners of a face with its place in the list of live ones, twice, for slots that are sent along.
constexpr size_t kMaxBytesOfFace = 2 * (60 + 12);

ViewOptions under_lamp() {
  ViewOptions options;
  options.show.shadows = Shadows::kAll;
  options.antialias = false;
  options.lights = {test::lamp_at({1, 4, 1.5})};
  return options;
}

CameraView view_from_above() {
  return look_at({2.4, 2.6, 3.6}, {0, 0, 0}, double{kFollowingWidth} / kFollowingHeight);
}

size_t faces_of(const World& world, std::span<const BodyId> bodies) {
  size_t faces = 0;
  for (const BodyId id : bodies) faces += world.body(id).mesh.live_faces();
  return faces;
}

// A hundred small rings over a large one of 1.1 million faces.
TEST(BodyUpload, sends_no_face_of_moving_bodies_and_rebuilds_only_silhouettes) {
  constexpr int kPieces = 100, kTicks = 40;
  std::vector<Soup> soups{test::torus(740, 743, 1.5, 0.3)};
  for (int i = 0; i < kPieces; ++i)
    soups.push_back(
        test::moved(test::torus(6, 8, 0.05, 0.02), {0.2 * (i % 10) - 1, 0.6, 0.2 * (i / 10) - 1}, 1));
  test::Stage stage(test::world_of_all(soups));
  std::vector<BodyId> pieces = stage.world().ids();
  pieces.erase(pieces.begin());
  const ViewOptions options = under_lamp();
  stage.draw(view_from_above(), options, kFollowingWidth, kFollowingHeight);
  const size_t sent = stage.renderer().uploaded_bytes();
  ShadowWork before = stage.renderer().shadow_work();
  const uint64_t faces = faces_of(stage.world(), pieces);
  for (int tick = 1; tick <= kTicks; ++tick) {
    for (const BodyId id : pieces) stage.apply(MovePiece{{id, 0}, {{0, -0.004 * tick, 0}, {1, 0, 0, 0}}});
    ASSERT_EQ(stage.renderer().uploaded_bytes(), sent);
    if (tick % (kTicks / 2) != 0) continue;
    stage.draw(view_from_above(), options, kFollowingWidth, kFollowingHeight);
    const ShadowWork after = stage.renderer().shadow_work();
    EXPECT_EQ(after.casters, before.casters);
    EXPECT_EQ(after.rebuilt, before.rebuilt + kPieces);
    EXPECT_EQ(after.faces, before.faces + faces);
    EXPECT_EQ(after.edges, before.edges + faces * 3 / 2);
    before = after;
  }
  EXPECT_EQ(stage.renderer().uploaded_bytes(), sent);
}

// Neither faces nor trees are touched: what the ticks changed is bodies and what is known of their contacts.
TEST(BodyUpload, sends_no_face_of_falling_bodies_and_edits_no_mesh_or_tree) {
  std::vector<Soup> soups{test::torus(300, 301, 1.5, 0.3)};
  for (int i = 0; i < 8; ++i)
    soups.push_back(test::moved(test::torus(6, 8, 0.05, 0.02), {0.3 * i - 1.2, 0.6, 1.5}, 1));
  test::Stage stage(test::world_of_all(soups));
  stage.apply(SetEnvironment{{{0, -9.81, 0}, -1}});
  const ViewOptions options = under_lamp();
  stage.pass(1);
  stage.draw(view_from_above(), options, kFollowingWidth, kFollowingHeight);
  const size_t sent = stage.renderer().uploaded_bytes();
  for (int frame = 0; frame < 10; ++frame) {
    stage.pass(5);
    stage.draw(view_from_above(), options, kFollowingWidth, kFollowingHeight);
    EXPECT_LT(stage.document().history().last().totals().bytes, 100'000u);
  }
  EXPECT_EQ(stage.renderer().uploaded_bytes(), sent);
  EXPECT_GT(stage.document().queue().physics().statistics().contacts, 0u);
}

// A sheet that is cut in two beside its edge, and a ball that stands by.
test::Stage sheet_in_two() {
  test::Stage stage(
      test::world_of_all({test::grid(60, 2), test::moved(test::sphere(20, 30, 0.6), {0, -0.9, 0}, 1)}));
  stage.cut({{0.8, 3, -1.3}, {0, -1, 0}}, {{0.8, 3, 1.3}, {0, -1, 0}}, 0.02);
  return stage;
}

struct Seen {
  Pixels picture;
  ShadowCounts shadow;
};
// Without glow: a renderer that sees a cut world for the first time takes its rims for boundaries as loaded.
Seen see(Renderer& renderer, const World& world) {
  ViewOptions look = under_lamp();
  look.rim_glow = false;
  const gl::Framebuffer canvas({kFollowingWidth, kFollowingHeight, 1, false});
  const CameraView view = view_from_above();
  renderer.draw(world, view, look, std::nullopt, {canvas.name(), 0, 0, kFollowingWidth, kFollowingHeight});
  return {read_pixels(canvas.name(), kFollowingWidth, kFollowingHeight),
          renderer.shadow_counts(world, view, look, 0, ShadowMethod::kRobust, true, kFollowingWidth,
                                 kFollowingHeight)};
}

// The sheet is flat, so that a renderer that sees it cut for the first time shades it alike.
void expect_matches_rebuild(test::Stage& stage) {
  auto fresh = Renderer::create();
  ASSERT_TRUE(fresh.ok());
  fresh->show(stage.world(), {});
  const Seen followed = see(stage.renderer(), stage.world()), rebuilt = see(*fresh, stage.world());
  EXPECT_EQ(followed.picture.rgb, rebuilt.picture.rgb);
  EXPECT_EQ(followed.shadow.stencil, rebuilt.shadow.stencil);
}

// Whichever side of the sheet it is, the smaller one is sent.
TEST(BodyUpload, sends_only_the_smaller_side_on_detach_reattach_and_delete) {
  for (const bool larger : {false, true}) {
    SCOPED_TRACE(larger ? "the larger side" : "the smaller side");
    test::Stage stage = sheet_in_two();
    const BodyId sheet = stage.world().ids().front();
    const Records<Piece>& pieces = stage.world().body(sheet).pieces;
    ASSERT_EQ(stage.world().live_pieces(), 3u);
    const uint32_t label = (pieces[0].faces > pieces[1].faces) == larger ? 0 : 1;
    const size_t most = std::min(pieces[0].faces, pieces[1].faces) * kMaxBytesOfFace;
    ASSERT_LT(8 * most, pieces[1 - label].faces * kMaxBytesOfFace + pieces[label].faces * kMaxBytesOfFace);
    expect_matches_rebuild(stage);
    const std::vector<Command> edits{MovePiece{{sheet, label}, {{0, -0.3, 0}, {1, 0, 0, 0}}}, Undo{}, Redo{}};
    for (const Command& edit : edits) {
      const size_t sent = stage.renderer().uploaded_bytes();
      const ShadowWork before = stage.renderer().shadow_work();
      stage.apply(edit);
      EXPECT_LE(stage.renderer().uploaded_bytes() - sent, most);
      expect_matches_rebuild(stage);
      EXPECT_LE(stage.renderer().shadow_work().casters, before.casters + 1);
    }
    const size_t sent = stage.renderer().uploaded_bytes();
    stage.apply(DeletePiece{{stage.world().ids().back(), label}});
    EXPECT_EQ(stage.renderer().uploaded_bytes(), sent);
    expect_matches_rebuild(stage);
    stage.apply(Undo{});
    expect_matches_rebuild(stage);
  }
}

}  // namespace
}  // namespace kerf
