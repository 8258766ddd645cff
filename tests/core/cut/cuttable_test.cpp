#include <gtest/gtest.h>

#include "core/cut/cut_step.h"
#include "core/document/document.h"
#include "core/edit/separation.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// Bodies that lie through one another, so that a stroke which meets one meets them all.
World crossing_bodies() {
  World world;
  world.add(make_body("torus", build(torus(16, 10, 0.5, 0.2))));
  world.add(make_body("sphere", build(sphere(12, 16, 0.5))));
  world.add(make_body("grid", build(grid(6, 1.2))));
  return world;
}

std::vector<Command> stroke_through_the_middle(Random& random, Rim rim, Scheme scheme) {
  CutSettings settings;
  settings.laser.radius = random.uniform(0.02, 0.05);
  settings.resolution.rim = rim;
  settings.resolution.scheme = scheme;
  settings.resolution.target_edge = settings.laser.radius * random.uniform(0.5, 2);
  const auto pose = [&](double side) {
    const Vec3 to(side, 0, random.uniform(-0.3, 0.3)), from(0, 3, 0);
    return Pose{from, glm::normalize(to - from)};
  };
  return {BeginStroke{settings, pose(-0.7)}, MoveBeam{pose(0.7)}, EndStroke{}};
}

// The hidden body is compared with a copy that no cut ever saw.
void expect_hidden_body_untouched(uint64_t seed, Rim rim, Scheme scheme) {
  Random random(seed);
  Document document(crossing_bodies());
  const auto ids = document.world().ids();
  const BodyId hidden = ids[random.below(ids.size())];
  const Placement aside{{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0}, {1, 0, 0, 0}};
  ASSERT_TRUE(document.apply(MovePiece{{hidden, 0}, aside}).ok());
  ASSERT_TRUE(document.apply(HidePiece{{hidden, 0}, true}).ok());
  const World before = document.world();
  for (const Command& c : stroke_through_the_middle(random, rim, scheme)) ASSERT_TRUE(document.apply(c).ok());
  ASSERT_TRUE(run_all(document).ok());
  for (const BodyId id : ids) {
    SCOPED_TRACE(before.body(id).name);
    const Body& body = document.world().body(id);
    if (id == hidden) {
      expect_same_body(body, before.body(id));
      EXPECT_EQ(find_fault(body.mesh), "");
    } else {
      EXPECT_NE(body.mesh.face_slots(), before.body(id).mesh.face_slots()) << "the stroke missed it";
    }
  }
}

TEST(CutStep, leaves_hidden_bodies_bit_identical_with_both_rims_and_schemes) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    for (const Rim rim : {Rim::kFaces, Rim::kSmooth}) {
      for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
        SCOPED_TRACE("seed " + std::to_string(seed) + (rim == Rim::kSmooth ? ", smooth" : ", faces") +
                     (scheme == Scheme::kOneToFour ? ", one-to-four" : ", longest-edge"));
        expect_hidden_body_untouched(seed, rim, scheme);
      }
    }
  }
}

TEST(Cuttable, bodies_are_the_visible_ones_in_order) {
  World world = crossing_bodies();
  const auto ids = world.ids();
  EXPECT_EQ(cuttable(world), ids);
  world.body(ids[1]).hidden = true;
  EXPECT_EQ(cuttable(world), (std::vector<BodyId>{ids[0], ids[2]}));
}

// A search that is open in a body when it is hidden comes to its end, for the world is not settled before.
TEST(CutStep, finishes_the_separation_search_in_a_body_hidden_meanwhile) {
  World world = world_of(grid(16, 1));
  CutSettings settings;
  settings.laser.radius = 0.05;
  settings.resolution.target_edge = 0.05;
  settings.search_a_move = 1;
  const std::vector<BeamMove> moves =
      subdivide({{{0.1, 1, -0.7}, {0, -1, 0}}, {{0.1, 1, 0.7}, {0, -1, 0}}}, 0.05, 2);
  ASSERT_TRUE(cut_whole(world, settings, moves).ok());
  ASSERT_FALSE(is_settled(world));
  only_body(world).hidden = true;
  continue_separation(world, kNoLimit);
  EXPECT_TRUE(is_settled(world));
  EXPECT_EQ(world.live_pieces(), 2u);
}

}  // namespace
}  // namespace kerf::test
