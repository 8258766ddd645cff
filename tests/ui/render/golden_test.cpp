#include <gtest/gtest.h>

#include "core/document/cut_effects.h"
#include "tests/support/checkout.h"
#include "tests/ui/golden.h"
#include "tests/ui/render/stage.h"
#include "ui/editor/single_step/stage_log.h"

namespace kerf {
namespace {

constexpr int kGoldenWidth = 320, kGoldenHeight = 200;

struct Golden {
  const char* name;
  ViewOptions options;
};

ViewOptions showing(const char* list) {
  ViewOptions options;
  options.show = *parse_show_list(list);
  return options;
}

std::vector<Golden> goldens(const test::Stage& stage) {
  const BodyId ball = stage.world().ids().front();
  std::vector<Golden> all;
  for (const char* name : {"aabb", "aabb-hit", "wire", "face-numbers", "pieces", "sizes", "normals"}) {
    all.push_back({name, showing(name)});
  }
  for (const char* name : {"shadows", "silhouette", "shadow-volumes", "shadow-stencil", "shadow-facing",
                           "shadow-compare", "shadow-reference"}) {
    all.push_back({name, showing((std::string("shadows,") + name).c_str())});
    all.back().options.lights.front().at = {-0.9, 0.9, 0.5};
  }
  Golden paper{"shadows-paper-look", showing("shadows")};
  paper.options.shadow = {.method = ShadowMethod::kPaperTwoVolumes, .extrusion = 4, .paper_look = true};
  all.push_back(paper);
  Golden lamps{"shadows-of-two-lamps", showing("shadows")};
  lamps.options.lights = {Light{Light::Kind::kPoint, {-1.5, 2.5, 2}, {1, 0.7, 0.4}, 0.9},
                          Light{Light::Kind::kPoint, {3.2, 2, 1}, {0.5, 0.7, 1}, 0.7}};
  all.push_back(lamps);
  Golden leaves{"aabb-leaves", showing("aabb")};
  leaves.options.tree.leaves_only = true;
  leaves.options.tree.body = ball;
  all.push_back(leaves);
  Golden blue{"aabb-orange-and-blue", showing("aabb")};
  blue.options.tree.deepest = 6;
  blue.options.tree.palette = BoxPalette::kOrangeAndBlue;
  all.push_back(blue);
  Golden shallow{"aabb-depth-3", showing("aabb")};
  shallow.options.tree.deepest = 3;
  all.push_back(shallow);
  Golden ghost{"ghost", {}};
  ghost.options.ghost = true;
  all.push_back(ghost);
  Golden day{"by-day", showing("shadows")};
  day.options.by_day = true;
  all.push_back(day);
  Golden black{"one-sided", {}};
  black.options.two_sided = false;
  all.push_back(black);
  Golden culled{"backs-culled", {}};
  culled.options.cull_backs = true;
  all.push_back(culled);
  Golden section{"section", showing("shadows,section")};
  section.options.section = SectionPlane{{0, 0.1, 0.15}, {0, 0, 1}};
  all.push_back(section);
  Golden spread{"pieces-spread", showing("pieces")};
  spread.options.pieces[{ball, 1}] = {.selected = true, .offset = {0, 0.35, 0}};
  all.push_back(spread);
  Golden hidden{"pieces-hidden", {}};
  hidden.options.pieces[{ball, 1}].hidden = true;
  hidden.options.ghost = true;
  all.push_back(hidden);
  Golden graph{"graph", showing("shadows,graph")};
  graph.options.graph = std::make_shared<DrawnGraph>(*graph_around_last_cut(stage.document()));
  graph.options.lit_face = FaceOfBody{ball, FaceId(3)};
  all.push_back(graph);
  Golden loops{"graph-loops", graph.options};
  DrawnGraph with_loops = *graph.options.graph;
  with_loops.loops = loop_paths(stage.world(), last_cut_faces(stage.document().history()));
  loops.options.graph = std::make_shared<DrawnGraph>(std::move(with_loops));
  all.push_back(loops);
  return all;
}

void expect_golden(const std::string& name, const Pixels& drawn) {
  test::expect_golden(test::checkout() / "tests/golden" / (name + ".png"), drawn);
}

TEST(Golden, every_overlay_matches_its_golden_image) {
  test::Stage stage = test::ball_and_ring();
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kGoldenWidth) / kGoldenHeight);
  for (const Golden& golden : goldens(stage))
    expect_golden(golden.name, stage.draw(view, golden.options, kGoldenWidth, kGoldenHeight));
}

TEST(Golden, a_hot_rim_glows_and_the_temperature_scale_shows_it) {
  test::Stage stage = test::ball_and_ring();
  stage.cut({{-0.4, -0.4, 4}, {0, 0, -1}}, {{0.5, -0.1, 4}, {0, 0, -1}}, 0.04, 0.25);
  const CameraView view = test::view_of_ball_and_ring(static_cast<double>(kGoldenWidth) / kGoldenHeight);
  expect_golden("heat-glow", stage.draw(view, showing("shadows"), kGoldenWidth, kGoldenHeight));
  expect_golden("heat", stage.draw(view, showing("heat"), kGoldenWidth, kGoldenHeight));
}

// The picture of the next stage of this kind that removed, made or hit anything.
Pixels draw_stage(test::Stage& stage, StageLog& log, StageRecord::Kind kind) {
  for (bool found = false; !found;) {
    const StageRecord record = stage.next_stage();
    log.note(stage.world(), record, FileUnit::kMetre);
    found = record.kind == kind && (!record.hit.empty() || !record.done.delta.bodies.empty());
  }
  ViewOptions options = showing("shadows");
  options.stage = log.marks(stage.world());
  return stage.draw(test::view_of_ball_and_ring(static_cast<double>(kGoldenWidth) / kGoldenHeight), options,
                    kGoldenWidth, kGoldenHeight);
}

TEST(Golden, the_stages_of_a_cut_match_their_golden_images) {
  test::Stage stage = test::ball_and_ring();
  stage.begin_cut({{-0.3, -0.5, 4}, {0, 0, -1}}, {{0.5, -0.3, 4}, {0, 0, -1}}, 0.12);
  StageLog log;
  using Kind = StageRecord::Kind;
  expect_golden("stage-hit", draw_stage(stage, log, Kind::kHit));
  log.draw_query(true);
  expect_golden("stage-query", draw_stage(stage, log, Kind::kHitAgain));
  log.draw_query(false);
  expect_golden("stage-remove", draw_stage(stage, log, Kind::kRemove));
  expect_golden("stage-refine", draw_stage(stage, log, Kind::kRefine));
}

TEST(Golden, the_sets_of_a_separation_match_their_golden_images) {
  test::Stage stage = test::ball_and_ring();
  stage.begin_cut({{-1.7, 0.1, 4}, {0, 0, -1}}, {{1.7, -0.2, 4}, {0, 0, -1}}, 0.06);
  StageLog log;
  expect_golden("stage-separate", draw_stage(stage, log, StageRecord::Kind::kSeparate));
}

}  // namespace
}  // namespace kerf
