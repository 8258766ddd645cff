#include "ui/editor/laser/comparison_cut.h"

#include <gtest/gtest.h>

#include "core/world/world.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

class TwinCutTest : public testing::Test {
 protected:
  TwinCutTest() {
    World world;
    world.add(make_body("sphere", test::build(test::sphere(24, 32, 1))));
    first = Document(std::move(world));
  }
  static CutSettings settings(double edge) {
    CutSettings s;
    s.laser.radius = 0.1;
    s.resolution.target_edge = edge;
    return s;
  }
  void draw_stroke(double y) {
    first.apply(BeginStroke{settings(0.025), {{-0.3, y, 5}, {0, 0, -1}}});
    first.apply(MoveBeam{{{0.3, y, 5}, {0, 0, -1}}});
    first.apply(EndStroke{});
    while (first.waiting() > 0) ASSERT_TRUE(first.step(8).ok());
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

TEST_F(TwinCutTest, differs_only_in_the_last_stroke) {
  draw_stroke(0.4);
  draw_stroke(-0.4);
  twin.follow(first, fine);
  cut_twin();
  EXPECT_EQ(state_hash(twin.world()), state_hash(first.world()));
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

}  // namespace
}  // namespace kerf
