#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "core/base/task.h"
#include "core/cut/cut_step.h"
#include "core/edit/separation.h"
#include "core/mesh/measures.h"
#include "core/world/body_mass.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/piece_sums.h"
#include "tests/support/runs.h"
#include "tests/support/same_world.h"
#include "tests/support/solids.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// A solid through which a stroke has gone, and whose rim is to be closed.
struct SolidBeforeClosing {
  World world;
  CutSettings settings;
  std::vector<BeamMove> path;
  UnfinishedRim rim;

  SolidBeforeClosing(const Soup& soup, const SolidStroke& stroke)
      : world(world_of(soup)), settings(stroke.settings) {
    make_solid(world.body(world.ids().front()), true);
    for (size_t i = 0; i + 1 < stroke.poses.size(); ++i)
      path.push_back({stroke.poses[i], stroke.poses[i + 1]});
    if (path.empty()) path.push_back({stroke.poses[0], stroke.poses[0]});
    settings.faces_per_step = 1;
    for (const BeamMove& move : path) {
      UnfinishedMove unfinished;
      while (cut_step(world, settings, {&move, 1}, unfinished)->moves == 0) {
      }
    }
  }
  const Body& body() const { return world.body(world.ids().front()); }

  bool is_closed() const {
    std::vector<Mesh::Side> open;
    body().mesh.append_open_sides(open);
    return open.empty();
  }

  Result<StepResult> step(const Progress* progress = nullptr) {
    return rim_step(world, settings, path, {}, rim, progress);
  }
  void settle() {
    while (!is_settled(world)) continue_separation(world, settings.search_a_move);
  }
  // Does steps until walls are being added. Returns whether they ever are.
  bool begin_to_add() {
    do {
      EXPECT_TRUE(step());
    } while (rim.begun() && !rim.is_uninterruptible());
    return rim.is_uninterruptible();
  }
};

// What anyone may ask for between two steps, also while walls are being added.
void expect_can_be_asked(const Body& body) {
  EXPECT_EQ(body.tree.leaf_count(), body.mesh.live_faces());
  size_t live = 0;
  std::vector<FaceId> neighbours;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    ++live;
    neighbours.clear();
    body.mesh.append_neighbours(FaceId(f), neighbours);
    for (const FaceId n : neighbours) ASSERT_TRUE(body.mesh.is_live(n));
    for (const VertexId v : body.mesh.corners(FaceId(f))) {
      Mesh::Star star;
      body.mesh.star(v, star);
      ASSERT_FALSE(star.faces.empty());
    }
  }
  EXPECT_EQ(live, body.mesh.live_faces());
}

TEST(ClosingInParts, gives_the_same_world_bit_for_bit_as_without_slicing) {
  size_t closed = 0;
  for (uint64_t seed = 1; seed <= runs(20); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<NamedSoup> solids = generated_solids();
    const NamedSoup& solid = solids[random.below(solids.size())];
    const SolidStroke stroke = random_solid_stroke(world_of(solid.soup), random);
    SolidBeforeClosing in_parts(solid.soup, stroke), unsliced(solid.soup, stroke);
    unsliced.settings.faces_per_step = std::numeric_limits<size_t>::max();
    ASSERT_TRUE(unsliced.step());
    size_t steps = 0;
    do {
      ASSERT_TRUE(in_parts.step());
      ++steps;
    } while (in_parts.rim.begun());
    EXPECT_GT(steps, 10);
    in_parts.settle();
    unsliced.settle();
    expect_same_world(in_parts.world, unsliced.world);
    closed += in_parts.is_closed();
  }
  EXPECT_GE(closed, runs(20) * 9 / 10);
}

TEST(ClosingInParts, adds_a_few_hundred_walls_per_slice_to_a_body_that_stays_queryable) {
  const SolidStroke stroke = straight_stroke({-1, 2, 0.1}, {1, 2, 0.1}, {0, -1, 0}, 0.002, {0, 5});
  SolidBeforeClosing cut(moved(sphere(48, 96, 0.5), {}, 1), stroke);
  ASSERT_TRUE(cut.begin_to_add());
  size_t parts = 0;
  while (cut.rim.is_uninterruptible()) {
    expect_can_be_asked(cut.body());
    const Result<StepResult> step = cut.step();
    ASSERT_TRUE(step);
    EXPECT_LE(step->delta.solid.wall_faces, kPartOfWork);
    ++parts;
  }
  EXPECT_GT(parts, 5);
  while (cut.rim.begun()) ASSERT_TRUE(cut.step());
  cut.settle();
  EXPECT_TRUE(cut.is_closed());
  EXPECT_EQ(find_fault(cut.body().mesh), "");
  expect_piece_sums(cut.body());
}

TEST(ClosingInParts, can_be_cancelled_only_before_walls_are_added) {
  const SolidStroke stroke = straight_stroke({-1, 2, 0.1}, {1, 2, 0.1}, {0, -1, 0}, 0.01, {0, 5});
  const Progress stop{[](double) { return false; }};
  SolidBeforeClosing before(sphere(16, 24, 0.5), stroke);
  ASSERT_TRUE(before.step());
  EXPECT_FALSE(before.step(&stop));
  EXPECT_FALSE(before.rim.begun());

  SolidBeforeClosing cut(sphere(16, 24, 0.5), stroke);
  ASSERT_TRUE(cut.begin_to_add());
  while (cut.rim.is_uninterruptible()) ASSERT_TRUE(cut.step(&stop));
  EXPECT_TRUE(cut.is_closed());
  EXPECT_EQ(find_fault(cut.body().mesh), "");
}

}  // namespace
}  // namespace kerf::test
