#include "tests/ui/render/stage.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"

namespace kerf::test {

namespace {

gl::OffscreenContext make_context() {
  auto context = gl::OffscreenContext::create();
  if (!context) throw std::runtime_error(context.error().message);
  return std::move(*context);
}

}  // namespace

Stage::Stage(World world) : context_(make_context()), document_(std::move(world)) {
  auto renderer = Renderer::create();
  if (!renderer) throw std::runtime_error(renderer.error().message);
  renderer_.emplace(std::move(*renderer));
  renderer_->show(document_.world(), {});
}

void Stage::begin_cut(const Pose& from, const Pose& to, double radius, double heat_width) {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, 20};
  settings.resolution.target_edge = radius;
  settings.heat_width = heat_width;
  document_.apply(BeginStroke{settings, from});
  document_.apply(MoveBeam{to});
  document_.apply(EndStroke{});
}

StageRecord Stage::next_stage() {
  if (!single_) single_.emplace(document_);
  const auto stage = single_->next();
  EXPECT_TRUE(stage.ok());
  if (!stage) return {};
  renderer_->follow(document_.world(), stage->done.delta);
  return *stage;
}

void Stage::cut(const Pose& from, const Pose& to, double radius, double heat_width) {
  begin_cut(from, to, radius, heat_width);
  while (document_.waiting() > 0) {
    const auto step = document_.step(16);
    ASSERT_TRUE(step.ok());
    renderer_->follow(document_.world(), step->delta);
    renderer_->catch_up(document_.world());
  }
}

void Stage::pass(Ticks ticks) {
  document_.apply(Play{});
  document_.apply(AdvanceTime{ticks, true});
  while (document_.waiting() > 0) {
    const auto step = document_.step(1);
    ASSERT_TRUE(step.ok());
    renderer_->follow(document_.world(), step->delta);
    renderer_->catch_up(document_.world());
  }
}

void Stage::apply(const Command& command) {
  const Outcome outcome = document_.apply(command);
  ASSERT_TRUE(outcome.ok());
  renderer_->follow(document_.world(), outcome.delta);
  renderer_->catch_up(document_.world());
}

Pixels Stage::draw(const CameraView& view, const ViewOptions& options, int width, int height) {
  const gl::Framebuffer picture({width, height, 1, false});
  const Target target{picture.name(), 0, 0, width, height};
  renderer_->draw(world(), view, options, std::nullopt, target);
  if (options.show.shadow_reference) renderer_->draw_traced(world(), view, options, target);
  return read_pixels(picture.name(), width, height);
}

Stage ball_and_ring() {
  World world;
  world.add(make_body("ball", build(sphere(10, 14, 1))));
  world.add(make_body("ring", build(moved(torus(14, 20, 0.9, 0.25), {1.9, -0.5, -0.9}, 1))));
  Stage stage(std::move(world));
  const Vec3 forward(0, 0, -1);
  stage.cut({{-1.5, 0.35, 4}, forward}, {{1.3, 0.55, 4}, forward}, 0.07);
  return stage;
}

CameraView view_of_ball_and_ring(double aspect) { return look_at({2.2, 2.0, 4.6}, {0.55, -0.1, 0}, aspect); }

PictureDifference difference(const Pixels& a, const Pixels& b) {
  EXPECT_EQ(a.rgb.size(), b.rgb.size());
  if (a.rgb.size() != b.rgb.size() || a.rgb.empty()) return {255, 1};
  PictureDifference d;
  for (size_t i = 0; i < a.rgb.size(); i += 3) {
    int most = 0;
    for (size_t c = 0; c < 3; ++c) {
      const int off = std::abs(a.rgb[i + c] - b.rgb[i + c]);
      d.mean += off;
      most = std::max(most, off);
    }
    d.changed += most > 24;
  }
  d.mean /= static_cast<double>(a.rgb.size());
  d.changed /= static_cast<double>(a.rgb.size()) / 3;
  return d;
}

}  // namespace kerf::test
