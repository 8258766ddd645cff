#include "ui/render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/made_meshes.h"
#include "tests/ui/render/stage.h"

namespace kerf {
namespace {

constexpr int kRenderWidth = 240, kRenderHeight = 200;

Pixels part_of(const Pixels& whole, int left, int width) {
  Pixels part{width, whole.height, {}};
  for (int y = 0; y < whole.height; ++y) {
    const auto from = whole.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * whole.width + left);
    part.rgb.insert(part.rgb.end(), from, from + 3 * width);
  }
  return part;
}

World torus_world() {
  World world;
  world.add(make_body("ring", test::build(test::torus(16, 24, 1, 0.3))));
  return world;
}

// Two renderers that share a window: each in its rectangle what it draws alone, and between them nothing.
TEST(Renderer, two_renderers_share_a_window_without_interference) {
  test::Stage stage = test::ball_and_ring();
  const World other = torus_world();
  auto second = Renderer::create();
  ASSERT_TRUE(second.ok());
  second->show(other, {});
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kRenderWidth) / kRenderHeight);
  ViewOptions options;
  options.show = *parse_show_list("aabb-hit,face-numbers");
  options.ghost = true;
  constexpr int kGap = 10, kWhole = 2 * kRenderWidth + kGap;
  for (const bool antialias : {false, true}) {
    options.antialias = antialias;
    const Pixels left = stage.draw(view, options, kRenderWidth, kRenderHeight);
    const gl::Framebuffer picture({kWhole, kRenderHeight, 1, false});
    picture.bind();
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (int frame = 0; frame < 2; ++frame) {
      stage.renderer().draw(stage.world(), view, options, std::nullopt,
                            {picture.name(), 0, 0, kRenderWidth, kRenderHeight});
      second->draw(other, view, options, std::nullopt,
                   {picture.name(), kRenderWidth + kGap, 0, kRenderWidth, kRenderHeight});
    }
    const Pixels both = read_pixels(picture.name(), kWhole, kRenderHeight);
    EXPECT_EQ(part_of(both, 0, kRenderWidth).rgb, left.rgb);
    const Pixels gap = part_of(both, kRenderWidth, kGap);
    for (size_t i = 0; i < gap.rgb.size(); i += 3) {
      ASSERT_TRUE(gap.rgb[i] == 255 && gap.rgb[i + 1] == 0 && gap.rgb[i + 2] == 255);
    }
    const gl::Framebuffer alone({kRenderWidth, kRenderHeight, 1, false});
    second->draw(other, view, options, std::nullopt, {alone.name(), 0, 0, kRenderWidth, kRenderHeight});
    EXPECT_EQ(part_of(both, kRenderWidth + kGap, kRenderWidth).rgb,
              read_pixels(alone.name(), kRenderWidth, kRenderHeight).rgb);
  }
}

// Whichever side is copied to arrays of its own: its faces are shaded as those of the body as loaded.
TEST(Renderer, a_detached_piece_looks_unchanged) {
  for (const uint32_t label : {0u, 1u}) {
    World world;
    world.add(make_body("ball", test::build(test::sphere(16, 24, 1))));
    test::Stage stage(std::move(world));
    stage.cut({{-1.5, 0.3, 5}, {0, 0, -1}}, {{1.5, 0.3, 5}, {0, 0, -1}}, 0.05);
    const CameraView view =
        look_at({1.5, 2, 3.5}, {0, 0, 0}, static_cast<double>(kRenderWidth) / kRenderHeight);
    ASSERT_EQ(stage.world().live_pieces(), 2u);
    const Pixels before = stage.draw(view, {}, kRenderWidth, kRenderHeight);
    stage.apply(HidePiece{{stage.world().ids().front(), label}, true});
    for (const BodyId id : stage.world().ids()) {
      if (stage.world().body(id).hidden) stage.apply(HidePiece{{id, label}, false});
    }
    ASSERT_EQ(stage.world().ids().size(), 2u);
    EXPECT_EQ(test::difference(before, stage.draw(view, {}, kRenderWidth, kRenderHeight)).changed, 0)
        << label;
  }
}

// After a piece was detached, the id of the body denotes a part of it, and without the delta the whole again.
TEST(Renderer, resend_draws_a_body_whose_id_denoted_a_part_of_it) {
  for (const uint32_t label : {0u, 1u}) {
    World world;
    world.add(make_body("ball", test::build(test::sphere(16, 24, 1))));
    test::Stage stage(std::move(world));
    stage.cut({{-1.5, 0.3, 5}, {0, 0, -1}}, {{1.5, 0.3, 5}, {0, 0, -1}}, 0.05);
    const World whole = stage.world();
    const CameraView view =
        look_at({1.5, 2, 3.5}, {0, 0, 0}, static_cast<double>(kRenderWidth) / kRenderHeight);
    const Pixels before = stage.draw(view, {}, kRenderWidth, kRenderHeight);
    stage.apply(HidePiece{{whole.ids().front(), label}, true});
    stage.renderer().resend(whole);
    const gl::Framebuffer picture({kRenderWidth, kRenderHeight, 1, false});
    stage.renderer().draw(whole, view, {}, std::nullopt, {picture.name(), 0, 0, kRenderWidth, kRenderHeight});
    const Pixels after = read_pixels(picture.name(), kRenderWidth, kRenderHeight);
    EXPECT_EQ(test::difference(before, after).changed, 0) << label;
  }
}

TEST(Renderer, a_hidden_piece_and_its_shadow_disappear_and_return) {
  test::Stage stage = test::ball_and_ring();
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kRenderWidth) / kRenderHeight);
  const Pixels plain = stage.draw(view, {}, kRenderWidth, kRenderHeight);
  ViewOptions options;
  const BodyId ring = stage.world().ids().back();
  options.pieces[{ring, 0}].hidden = true;
  const Pixels hidden = stage.draw(view, options, kRenderWidth, kRenderHeight);
  EXPECT_GT(test::difference(plain, hidden).changed, 0.05);
  EXPECT_EQ(stage.draw(view, {}, kRenderWidth, kRenderHeight).rgb, plain.rgb);
}

TEST(Renderer, a_hidden_body_and_its_shadow_are_not_drawn_whatever_the_options) {
  test::Stage stage = test::ball_and_ring();
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kRenderWidth) / kRenderHeight);
  const PieceId ring{stage.world().ids().back(), 0};
  for (const bool normals : {false, true}) {
    ViewOptions options;
    options.show.normals = normals;
    ViewOptions without = options;
    without.pieces[ring].hidden = true;
    const Pixels plain = stage.draw(view, options, kRenderWidth, kRenderHeight);
    const Pixels hidden = stage.draw(view, without, kRenderWidth, kRenderHeight);
    stage.apply(HidePiece{ring, true});
    EXPECT_EQ(stage.draw(view, options, kRenderWidth, kRenderHeight).rgb, hidden.rgb);
    stage.apply(HidePiece{ring, false});
    EXPECT_EQ(stage.draw(view, options, kRenderWidth, kRenderHeight).rgb, plain.rgb);
  }
}

TEST(Renderer, lamps_keep_their_brightness_while_debris_flies_away) {
  World world;
  world.add(make_body("ball", test::build(test::sphere(16, 24, 1))));
  world.add(make_body("debris", test::build(test::moved(test::sphere(6, 8, 0.05), {0, 3, 8}, 1))));
  test::Stage stage(std::move(world));
  const CameraView view =
      look_at({1.5, 2, 3.5}, {0, 0, 0}, static_cast<double>(kRenderWidth) / kRenderHeight);
  ViewOptions options;
  options.lights = {Light{Light::Kind::kPoint, {3, 4, 3}, {1, 1, 1}, 0.4}};
  const Pixels before = stage.draw(view, options, kRenderWidth, kRenderHeight);
  stage.apply(MovePiece{{stage.world().ids().back(), 0}, {{0, 0, 300}, {1, 0, 0, 0}}});
  const Pixels after = stage.draw(view, options, kRenderWidth, kRenderHeight);
  EXPECT_EQ(test::difference(before, after).changed, 0);
}

TEST(Renderer, a_section_plane_hides_boxes_and_the_marks_of_a_stage) {
  test::Stage stage = test::ball_and_ring();
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kRenderWidth) / kRenderHeight);
  ViewOptions options;
  options.show.section = true;
  options.section = SectionPlane{{0, -10, 0}, {0, 1, 0}};
  const Pixels hidden = stage.draw(view, options, kRenderWidth, kRenderHeight);
  StageMarks marks;
  StageMarks::OfBody& ball = marks.bodies.emplace_back();
  ball.body = stage.world().ids().front();
  ball.fills.push_back({{Vec3(-1, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)}});
  ball.lines.push_back({{-1, 0.5, 1}, {1, 0.5, 1}});
  ball.lines.push_back({{-1, 0.2, 1}, {1, 0.2, 1}, 0, StageMarks::Kind::kLast});
  options.stage = std::make_shared<StageMarks>(std::move(marks));
  options.show.aabb = true;
  EXPECT_EQ(stage.draw(view, options, kRenderWidth, kRenderHeight).rgb, hidden.rgb);
  options.section->normal = {0, -1, 0};
  const Pixels shown = stage.draw(view, options, kRenderWidth, kRenderHeight);
  options.stage = nullptr;
  options.show.aabb = false;
  const Pixels plain = stage.draw(view, options, kRenderWidth, kRenderHeight);
  EXPECT_GT(test::difference(shown, plain).changed, 0.01);
}

TEST(Renderer, the_ground_hides_no_mesh_that_is_added_below_it) {
  World world;
  world.add(make_body("ball", test::build(test::sphere(16, 24, 1))));
  test::Stage stage(std::move(world));
  World larger = stage.world();
  Delta delta;
  delta.created = {
      larger.add(make_body("added", test::build(test::moved(test::sphere(16, 24, 1), {2, -4, 0}, 1))))};
  stage.renderer().follow(larger, delta);
  const CameraView view = look_at({1, 3, 12}, {1, -2, 0}, static_cast<double>(kRenderWidth) / kRenderHeight);
  const ShadowCounts counts = stage.renderer().shadow_counts(
      larger, view, ViewOptions(), 0, ShadowMethod::kRobust, true, kRenderWidth, kRenderHeight);
  EXPECT_GT(std::ranges::count_if(counts.faces, [](uint32_t mark) { return mark >> 24 == 2; }), 100);
}

TEST(Renderer, the_ghost_shows_only_removed_parts) {
  test::Stage stage = test::ball_and_ring();
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kRenderWidth) / kRenderHeight);
  ViewOptions options;
  const Pixels plain = stage.draw(view, options, kRenderWidth, kRenderHeight);
  options.ghost = true;
  const Pixels ghost = stage.draw(view, options, kRenderWidth, kRenderHeight);
  size_t off = 0;
  for (size_t i = 0; i < ghost.rgb.size(); i += 3) off += std::abs(ghost.rgb[i] - plain.rgb[i]) > 4;
  EXPECT_GT(off, 100u);
  EXPECT_LT(off, static_cast<size_t>(kRenderWidth * kRenderHeight) / 20);
}

TEST(Renderer, removed_faces_of_a_hidden_body_are_not_shown) {
  World world;
  world.add(make_body("ball", test::build(test::sphere(16, 24, 1))));
  test::Stage stage(std::move(world));
  stage.cut({{-0.3, 0.3, 5}, {0, 0, -1}}, {{0.3, 0.3, 5}, {0, 0, -1}}, 0.05);
  stage.apply(HidePiece{{stage.world().ids().front(), 0}, true});
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kRenderWidth) / kRenderHeight);
  const Pixels plain = stage.draw(view, {}, kRenderWidth, kRenderHeight);
  ViewOptions ghost, numbers;
  ghost.ghost = true;
  numbers.show.face_numbers = true;
  EXPECT_EQ(stage.draw(view, ghost, kRenderWidth, kRenderHeight).rgb, plain.rgb);
  EXPECT_EQ(stage.draw(view, numbers, kRenderWidth, kRenderHeight).rgb, plain.rgb);
}

TEST(Renderer, face_numbers_of_a_small_image_are_no_smaller_than_their_bitmaps) {
  test::Stage stage = test::ball_and_ring();
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kRenderWidth) / kRenderHeight);
  ViewOptions options;
  options.show.face_numbers = true;
  const Pixels usual = stage.draw(view, options, kRenderWidth, kRenderHeight);
  options.mark_scale = 0.3;
  EXPECT_EQ(stage.draw(view, options, kRenderWidth, kRenderHeight).rgb, usual.rgb);
}

TEST(Renderer, shadow_methods_do_not_differ_without_a_light) {
  World world;
  world.add(make_body("ball", test::build(test::sphere(16, 24, 1))));
  test::Stage stage(std::move(world));
  const CameraView view = look_at({2, 4, 6}, {0, 0, 0}, static_cast<double>(kRenderWidth) / kRenderHeight);
  ViewOptions options;
  options.show.shadow_compare = true;
  options.shadow.extrusion = 1e-6;  // the second method draws no shadow
  stage.draw(view, options, kRenderWidth, kRenderHeight);
  EXPECT_GT(stage.renderer().differing_pixels(), 100u);
  options.lights.clear();
  stage.draw(view, options, kRenderWidth, kRenderHeight);
  EXPECT_EQ(stage.renderer().differing_pixels(), 0u);
}

size_t count_greenish(const Pixels& pixels) {
  size_t count = 0;
  for (size_t i = 0; i < pixels.rgb.size(); i += 3)
    count += pixels.rgb[i + 1] > pixels.rgb[i + 2] + 25 && pixels.rgb[i + 1] > 150 ? 1 : 0;
  return count;
}

// The last colour of the scale is a pale yellow.
TEST(Renderer, a_scalar_field_colours_faces_and_leaves_no_trace) {
  test::Stage stage = test::ball_and_ring();
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kRenderWidth) / kRenderHeight);
  ViewOptions options;
  options.antialias = false;
  const auto draw = [&] { return stage.draw(view, options, kRenderWidth, kRenderHeight); };
  const Pixels before = draw();
  const size_t memory = stage.renderer().memory().graphics;
  ScalarField field;
  for (const BodyId id : stage.world().ids()) {
    field.of_bodies[id] = std::make_shared<const FaceScalars>(stage.world().body(id).mesh.face_slots(), 5.0f);
  }
  field.low = 1;
  field.high = 2;
  options.scalar = std::make_shared<const ScalarField>(field);
  const size_t pale = count_greenish(draw());
  EXPECT_GT(pale, count_greenish(before) + 2000);
  EXPECT_GT(stage.renderer().memory().graphics, memory);
  const size_t sent = stage.renderer().uploaded_bytes();
  field.high = 9;  // in the middle of the colours, without sending anything
  options.scalar = std::make_shared<const ScalarField>(field);
  EXPECT_LT(count_greenish(draw()), pale / 4);
  EXPECT_EQ(stage.renderer().uploaded_bytes(), sent);
  options.scalar.reset();
  EXPECT_EQ(draw().rgb, before.rgb);
  EXPECT_EQ(stage.renderer().memory().graphics, memory);
}

// A ball of so few faces that all its edges are sharp.
TEST(Renderer, each_shading_mode_differs_and_by_angle_is_restored) {
  World world;
  world.add(make_body("ball", test::build(test::sphere(4, 6, 1))));
  test::Stage stage(std::move(world));
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kRenderWidth) / kRenderHeight);
  ViewOptions options;
  const auto draw = [&](Shading shading) {
    options.shading = shading;
    return stage.draw(view, options, kRenderWidth, kRenderHeight);
  };
  const Pixels before = draw(Shading::kByAngle);
  EXPECT_GT(test::difference(before, draw(Shading::kFlat)).mean, 0.2);
  EXPECT_GT(test::difference(before, draw(Shading::kSmooth)).mean, 0.2);
  EXPECT_EQ(draw(Shading::kByAngle).rgb, before.rgb);
}

TEST(Antialias, is_as_wanted_for_small_images_and_fails_beyond_the_memory) {
  const auto context = gl::OffscreenContext::create();
  ASSERT_TRUE(context.ok());
  for (const bool wanted : {false, true}) {
    const auto small = affordable_antialias(kRenderWidth, kRenderHeight, wanted);
    ASSERT_TRUE(small.ok());
    EXPECT_EQ(*small, wanted);
    const auto huge = affordable_antialias(1'000'000, 1000, wanted);
    ASSERT_FALSE(huge.ok());
    EXPECT_NE(huge.error().message.find("use a smaller one"), std::string::npos);
  }
}

}  // namespace
}  // namespace kerf
