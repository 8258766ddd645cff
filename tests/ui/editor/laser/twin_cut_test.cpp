#include "ui/editor/laser/comparison_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/laser/resolution_chart.h"

namespace kerf {
namespace {

class TwinCutTest : public testing::Test {
 protected:
  TwinCutTest() {
    World world;
    world.add(make_body("sphere", test::build(test::sphere(24, 32, 1))));
    first = Document(std::move(world));
  }
  static CutSettings settings(double edge, double radius = 0.1) {
    CutSettings s;
    s.laser.radius = radius;
    s.resolution.target_edge = edge;
    return s;
  }
  void cut_first() {
    while (first.waiting() > 0) ASSERT_TRUE(first.step(8).ok());
  }
  void draw_stroke(double y, double radius = 0.1) {
    first.apply(BeginStroke{settings(0.025, radius), {{-0.3, y, 5}, {0, 0, -1}}});
    first.apply(MoveBeam{{{0.3, y, 5}, {0, 0, -1}}});
    first.apply(EndStroke{});
    cut_first();
  }
  void recut(double edge, double radius) {
    ASSERT_TRUE(first.apply(Recut{settings(edge, radius)}).ok());
    cut_first();
  }
  ResolutionChart chart_of_last_stroke() {
    ResolutionChart chart;
    chart.begin(first);
    while (chart.busy()) chart.advance(first, 1);
    return chart;
  }
  void cut_twin() {
    while (twin.waiting() > 0) ASSERT_TRUE(twin.step(8).ok());
  }
  Document first;
  TwinCut twin;
  ResolutionControls coarse{.edge_fraction = 1, .rim = Rim::kFaces},
      fine{.edge_fraction = 0.25, .rim = Rim::kFaces};
};

TEST_F(TwinCutTest, the_same_resolution_gives_the_same_world_and_a_coarser_one_differs) {
  draw_stroke(0);
  EXPECT_TRUE(twin.follow(first, fine));
  cut_twin();
  EXPECT_EQ(state_hash(twin.world()), state_hash(first.world()));
  EXPECT_TRUE(twin.follow(first, coarse));
  cut_twin();
  EXPECT_LT(twin.world().live_faces(), first.world().live_faces());
}

TEST_F(TwinCutTest, follows_a_continuing_stroke) {
  EXPECT_TRUE(twin.follow(first, fine));
  EXPECT_EQ(twin.waiting(), 0u);
  first.apply(BeginStroke{settings(0.025), {{-0.3, 0, 5}, {0, 0, -1}}});
  EXPECT_TRUE(twin.follow(first, fine));
  EXPECT_EQ(twin.waiting(), 1u);
  cut_twin();
  first.apply(MoveBeam{{{0.3, 0, 5}, {0, 0, -1}}});
  EXPECT_FALSE(twin.follow(first, fine));
  EXPECT_GT(twin.waiting(), 0u);
  EXPECT_FALSE(twin.follow(first, fine));
}

TEST_F(TwinCutTest, follows_edits_of_an_uncut_document) {
  EXPECT_TRUE(twin.follow(first, fine));
  ASSERT_TRUE(first.apply(SubdividePiece{{first.world().ids().front(), 0}}).ok());
  EXPECT_TRUE(twin.follow(first, fine));
  EXPECT_EQ(state_hash(twin.world()), state_hash(first.world()));
  EXPECT_FALSE(twin.follow(first, fine));
}

TEST_F(TwinCutTest, differs_only_in_the_last_stroke) {
  draw_stroke(0.4);
  draw_stroke(-0.4);
  twin.follow(first, fine);
  cut_twin();
  EXPECT_EQ(state_hash(twin.world()), state_hash(first.world()));
}

TEST_F(TwinCutTest, a_change_after_the_last_stroke_must_be_undone_before_a_comparison) {
  draw_stroke(0);
  ASSERT_TRUE(first.apply(RenamePiece{{first.world().ids().front(), 0}, "ball"}).ok());
  EXPECT_TRUE(twin.follow(first, fine));
  EXPECT_FALSE(twin.there());
  EXPECT_STREQ(no_comparison_reason(first), "Undo later changes to compare the last cut");
  first.apply(Undo{});
  EXPECT_TRUE(twin.follow(first, fine));
  EXPECT_TRUE(twin.there());
}

TEST_F(TwinCutTest, restarts_for_another_document) {
  draw_stroke(0);
  twin.follow(first, coarse);
  twin.forget();
  EXPECT_FALSE(twin.there());
  first = Document();
  EXPECT_TRUE(twin.follow(first, coarse));
  EXPECT_EQ(twin.world().live_faces(), 0u);
}

TEST_F(TwinCutTest, the_chart_of_a_recut_measures_its_rim_against_the_new_radius) {
  draw_stroke(0.1, 0.16);
  const std::vector<ResolutionChart::Sample> fresh = chart_of_last_stroke().samples();
  ASSERT_EQ(fresh.size(), ResolutionChart::kFractions.size());
  first.apply(Undo{});
  draw_stroke(0.1);
  recut(0.025, 0.16);
  const std::vector<ResolutionChart::Sample> again = chart_of_last_stroke().samples();
  ASSERT_EQ(again.size(), fresh.size());
  for (size_t i = 0; i < fresh.size(); ++i) {
    ASSERT_TRUE(fresh[i].error && again[i].error) << i;
    EXPECT_EQ(*again[i].error, *fresh[i].error) << i;
    EXPECT_EQ(again[i].faces, fresh[i].faces) << i;
  }
  EXPECT_LT(*again.back().error, *again.front().error);
}

TEST_F(TwinCutTest, time_within_a_stroke_leaves_the_swept_volume_unchanged) {
  const auto at = [](double x, double y) { return Pose{{x, y, 5}, {0, 0, -1}}; };
  // Around a corner, so that a beam that returned to its start would sweep another volume.
  std::vector<Command> stroke{BeginStroke{settings(0.025), at(-0.3, 0.1)}, MoveBeam{at(0.3, 0.1)},
                              MoveBeam{at(0.3, 0.4)}, EndStroke{}};
  for (const Command& command : stroke) ASSERT_TRUE(first.apply(command).ok());
  cut_first();
  const auto error = [&] {
    RimError rim(first.world(), stroke, 0.2);
    while (!rim.done()) rim.advance();
    return rim.error();
  };
  const std::optional<double> steady = error();
  ASSERT_TRUE(steady.has_value());
  stroke.insert(stroke.begin() + 2, Command(AdvanceTime{1}));
  EXPECT_EQ(error(), steady);
}

TEST_F(TwinCutTest, a_finished_chart_lasts_until_its_stroke_is_no_longer_the_last_one) {
  draw_stroke(0.1);
  ResolutionChart chart = chart_of_last_stroke();
  const auto size = [&] {
    chart.advance(first, 1);
    return chart.samples().size();
  };
  ASSERT_EQ(size(), ResolutionChart::kFractions.size());
  recut(0.05, 0.1);
  EXPECT_EQ(size(), ResolutionChart::kFractions.size()) << "only the resolution has changed";
  recut(0.05, 0.16);
  EXPECT_EQ(size(), 0u) << "its radius was another";

  chart = chart_of_last_stroke();
  draw_stroke(-0.1);
  EXPECT_EQ(size(), 0u);
  chart = chart_of_last_stroke();
  first.apply(Undo{});
  draw_stroke(-0.2);  // the same step of the history
  EXPECT_EQ(size(), 0u);
}

TEST_F(TwinCutTest, the_chart_cuts_with_the_scheme_and_the_rim_of_the_stroke) {
  for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
    for (const Rim rim : {Rim::kFaces, Rim::kSmooth}) {
      CutSettings own = settings(0.025);
      own.resolution.scheme = scheme;
      own.resolution.rim = rim;
      first.apply(BeginStroke{own, {{-0.3, 0.1, 5}, {0, 0, -1}}});
      first.apply(MoveBeam{{{0.3, 0.1, 5}, {0, 0, -1}}});
      first.apply(EndStroke{});
      cut_first();
      ResolutionChart chart = chart_of_last_stroke();
      ASSERT_EQ(chart.samples().size(), ResolutionChart::kFractions.size());
      EXPECT_EQ(chart.samples()[2].faces, first.history().last().totals().statistics.faces_made);
      own.resolution.rim = rim == Rim::kFaces ? Rim::kSmooth : Rim::kFaces;
      ASSERT_TRUE(first.apply(Recut{own}).ok());
      cut_first();
      chart.advance(first, 1);
      EXPECT_TRUE(chart.samples().empty()) << "its rim was another";
      first.apply(Undo{});
      first.apply(Undo{});
      cut_first();
    }
  }
}

// Against the distances from the segment that the axis sweeps, seen along the beam.
TEST_F(TwinCutTest, the_chart_has_five_resolutions_and_the_errors_of_their_rims) {
  draw_stroke(0.1);
  ResolutionChart chart;
  chart.begin(first);
  while (chart.busy()) chart.advance(first, 1e-4);
  ASSERT_EQ(chart.samples().size(), ResolutionChart::kFractions.size());
  for (size_t i = 1; i < chart.samples().size(); ++i)
    EXPECT_GT(chart.samples()[i].faces, chart.samples()[i - 1].faces);
  EXPECT_LT(*chart.samples().back().error, 0.5 * *chart.samples().front().error);
  twin.follow(first, coarse);
  cut_twin();
  const Mesh& mesh = twin.world().body(twin.world().ids().front()).mesh;
  std::vector<Mesh::Side> sides;
  mesh.append_open_sides(sides);
  ASSERT_FALSE(sides.empty());
  double expected = 0;
  for (const Mesh::Side& side : sides) {
    for (int quarter = 0; quarter <= 4; ++quarter) {
      const Vec3 p =
          mesh.position(side.from) + quarter / 4.0 * (mesh.position(side.to) - mesh.position(side.from));
      const Vec2 nearest(std::clamp(p.x, -0.3, 0.3), 0.1);
      expected = std::max(expected, std::abs(glm::length(Vec2(p.x, p.y) - nearest) - 0.1));
    }
  }
  const auto& stroke = first.history().step(*first.history().last_cut()).commands();
  RimError rim(twin.world(), stroke, 0.2);
  while (!rim.done()) rim.advance();
  EXPECT_NEAR(rim.error().value_or(0), expected, 1e-12);
  chart.begin(first);
  draw_stroke(-0.1);
  chart.advance(first, 1);
  EXPECT_FALSE(chart.busy());
}

}  // namespace
}  // namespace kerf
