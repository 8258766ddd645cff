#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/made_meshes.h"
#include "tests/ui/render/shadow_oracle.h"
#include "tests/ui/render/shadow_scenes.h"

namespace kerf {
namespace {

constexpr int kLiveWidth = 200, kLiveHeight = 150;

ViewOptions under(const Light& light) {
  ViewOptions options;
  options.show.shadows = Shadows::kAll;
  options.lights = {light};
  return options;
}

CameraView view_from(const Vec3& eye) {
  return look_at(eye, {0, 0, 0}, static_cast<double>(kLiveWidth) / kLiveHeight);
}

test::Stage torus_over_floor() {
  return test::Stage(
      test::world_of_all({test::torus(60, 90, 1, 0.35), test::moved(test::floor_at(0, 9), {0, -0.9, 0}, 1)}));
}

const Light kLamp = test::lamp_at({1, 4, 1.5});

TEST(LiveShadows, moving_the_camera_computes_nothing) {
  test::Stage stage = torus_over_floor();
  stage.draw(view_from({3, 2, 4}), under(kLamp), kLiveWidth, kLiveHeight);
  const ShadowWork before = stage.renderer().shadow_work();
  EXPECT_EQ(before.casters, 2u);
  EXPECT_EQ(before.rebuilt, 2u);
  for (int i = 0; i < 5; ++i)
    stage.draw(view_from({3.0 - i, 2.0 + i, 4}), under(kLamp), kLiveWidth, kLiveHeight);
  const ShadowWork after = stage.renderer().shadow_work();
  EXPECT_EQ(after.casters, before.casters);
  EXPECT_EQ(after.rebuilt, before.rebuilt);
  EXPECT_EQ(after.faces, before.faces);
  EXPECT_EQ(after.edges, before.edges);
}

TEST(LiveShadows, moving_a_light_computes_only_its_own_volumes) {
  test::Stage stage = torus_over_floor();
  ViewOptions options = under(kLamp);
  options.lights.push_back(test::sun_from({0.3, 1, 0.1}));
  stage.draw(view_from({3, 2, 4}), options, kLiveWidth, kLiveHeight);
  const ShadowWork before = stage.renderer().shadow_work();
  options.lights[1].at.x = -0.2;
  stage.draw(view_from({3, 2, 4}), options, kLiveWidth, kLiveHeight);
  EXPECT_EQ(stage.renderer().shadow_work().rebuilt, before.rebuilt + 2);
  EXPECT_EQ(stage.renderer().shadow_work().casters, before.casters);
}

TEST(LiveShadows, a_small_cut_updates_only_touched_faces_and_keeps_shadows_correct) {
  test::Stage stage = torus_over_floor();
  const CameraView view = view_from({2.4, 2.6, 3.6});
  stage.draw(view, under(kLamp), kLiveWidth, kLiveHeight);
  const ShadowWork before = stage.renderer().shadow_work();
  const size_t faces = stage.world().live_faces();
  stage.cut({{1.0, 3, 0.05}, {0, -1, 0}}, {{1.02, 3, 0.05}, {0, -1, 0}}, 0.03);
  stage.draw(view, under(kLamp), kLiveWidth, kLiveHeight);
  const ShadowWork after = stage.renderer().shadow_work();
  EXPECT_EQ(after.rebuilt, before.rebuilt);
  EXPECT_GT(after.faces, before.faces);
  EXPECT_LT(after.faces - before.faces, faces / 5);
  const test::ShadowVerdict v = test::ShadowTrial(stage, kLamp, view, kLiveWidth, kLiveHeight).robust();
  SCOPED_TRACE(v.summary());
  EXPECT_EQ(v.wrong, 0u);
  EXPECT_EQ(v.miscounted, 0u);
  EXPECT_GT(v.in_shadow, 2000u);
}

constexpr ShadowMethod kMethods[] = {ShadowMethod::kPaperOneVolume, ShadowMethod::kPaperTwoVolumes,
                                     ShadowMethod::kRobust};

// Pixels that are in shadow with a method.
size_t shadowed_pixels(test::Stage& stage, const CameraView& view, ShadowMethod method) {
  const ShadowCounts counts = stage.renderer().shadow_counts(stage.world(), view, under(kLamp), 0, method,
                                                             true, kLiveWidth, kLiveHeight);
  return counts.stencil.size() -
         static_cast<size_t>(std::count(counts.stencil.begin(), counts.stencil.end(), uint8_t{0}));
}

TEST(LiveShadows, a_world_without_bodies_has_no_shadow) {
  test::Stage stage{World()};
  const CameraView view = view_from({2.4, 2.6, 3.6});
  stage.draw(view, under(kLamp), kLiveWidth, kLiveHeight);
  for (const ShadowMethod method : kMethods) EXPECT_EQ(shadowed_pixels(stage, view, method), 0u);
}

// All that casts is burned away under a light that stays.
TEST(LiveShadows, a_removed_part_loses_its_shadow) {
  test::Stage stage(test::world_of_all(
      {test::floor_at(0, 9), test::box({0, 1, 0}, {0.3, 0.3, 0.3}), test::box({1, 1, 0}, {0.3, 0.3, 0.3})}));
  const CameraView view = view_from({2.4, 2.6, 3.6});
  for (const ShadowMethod method : kMethods) EXPECT_GT(shadowed_pixels(stage, view, method), 200u);
  const ShadowWork before = stage.renderer().shadow_work();
  stage.cut({{-3, 1, 0}, {1, 0, 0}}, {{-3, 1, 0.001}, {1, 0, 0}}, 0.5);
  ASSERT_EQ(stage.world().live_faces(), 2u);
  for (const ShadowMethod method : kMethods) EXPECT_EQ(shadowed_pixels(stage, view, method), 0u);
  EXPECT_EQ(stage.renderer().shadow_work().rebuilt, before.rebuilt);
}

struct SeenShadow {
  Pixels picture;
  ShadowCounts counts;
};
SeenShadow see(Renderer& renderer, const World& world, bool antialias, int width, int height) {
  const CameraView view = look_at({2.4, 2.6, 3.6}, {0, 0, 0}, static_cast<double>(width) / height);
  ViewOptions options = under(kLamp);
  options.antialias = antialias;
  const gl::Framebuffer canvas({width, height, 1, false});
  renderer.draw(world, view, options, std::nullopt, {canvas.name(), 0, 0, width, height});
  return {read_pixels(canvas.name(), width, height),
          renderer.shadow_counts(world, view, options, 0, ShadowMethod::kRobust, true, width, height)};
}

// Depth, stencil and the light that is added up are of the size of the picture, whatever came before it.
TEST(LiveShadows, follow_the_window_size) {
  test::Stage stage = torus_over_floor();
  using Size = std::pair<int, int>;
  for (const bool antialias : {false, true}) {
    for (const auto& [width, height] : {Size{200, 150}, Size{320, 150}, Size{320, 240}, Size{90, 260}}) {
      SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
      auto fresh = Renderer::create();
      ASSERT_TRUE(fresh.ok());
      fresh->show(stage.world(), {});
      const SeenShadow resized = see(stage.renderer(), stage.world(), antialias, width, height),
                       rebuilt = see(*fresh, stage.world(), antialias, width, height);
      EXPECT_EQ(resized.picture.rgb, rebuilt.picture.rgb);
      EXPECT_EQ(resized.counts.stencil, rebuilt.counts.stencil);
      EXPECT_GT(std::count(rebuilt.counts.stencil.begin(), rebuilt.counts.stencil.end(), uint8_t{2}), 500);
    }
  }
}

// Two hundred pieces drawn apart, some hidden, under a lamp: each shades where it is drawn.
TEST(LiveShadows, two_hundred_pieces_cast_shadows_where_they_are_drawn) {
  World world;
  Soup plates;
  for (int i = 0; i < 200; ++i) {
    plates = test::both(plates,
                        test::moved(test::plate(0.16),
                                    {(i % 20) * 0.2 - 1.9, 0.6 + 0.01 * (i % 7), (i / 20) * 0.2 - 0.9}, 1));
  }
  world.add(make_body("plates", test::build(plates)));
  world.add(make_body("floor", test::build(test::floor_at(0, 9))));
  Body& body = world.body(world.ids().front());
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) body.mesh.edit_data(FaceId(f)).piece = f / 2;
  const BodyId id = world.ids().front();
  test::Stage stage(std::move(world));
  ViewOptions options = under(kLamp);
  for (uint32_t piece = 0; piece < 200; ++piece) {
    PieceLook& look = options.pieces[{id, piece}];
    look.offset = {0.3 * ((piece % 20) / 10.0 - 1), 0.1 * (piece % 5), 0};
    look.hidden = piece % 11 == 0;
  }
  const CameraView view = view_from({2.4, 2.6, 3.6});
  stage.draw(view, options, kLiveWidth, kLiveHeight);
  ShadowReference traced =
      stage.renderer().shadow_reference(stage.world(), view, options, 0, false, kLiveWidth, kLiveHeight);
  traced.trace(static_cast<size_t>(kLiveWidth) * kLiveHeight);
  const test::ShadowVerdict v =
      test::judge(stage.renderer().shadow_counts(stage.world(), view, options, 0, ShadowMethod::kRobust,
                                                 false, kLiveWidth, kLiveHeight),
                  traced);
  SCOPED_TRACE(v.summary());
  EXPECT_EQ(v.wrong, 0u);
  EXPECT_EQ(v.miscounted, 0u);
  EXPECT_GT(v.in_shadow, 500u);
}

}  // namespace
}  // namespace kerf
