#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

#include "core/kerf.h"
#include "tests/api/sheets.h"

namespace kerf::test {
namespace {

constexpr double kNoTime = std::numeric_limits<double>::infinity();
constexpr size_t kNoFaces = std::numeric_limits<size_t>::max();

// A stroke of several keys over the unit square, at random.
Stroke random_stroke(std::mt19937& random) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  Stroke stroke;
  const size_t keys = 2 + random() % 4;
  for (size_t i = 0; i < keys; ++i)
    stroke.keys.push_back({3.0 + double(i), {between(-0.2, 1.2), 2, between(-0.2, 1.2)}, {0, -1, 0}});
  stroke.radius = between(0.01, 0.03);
  stroke.range = {0, 4};
  return stroke;
}

// Cuts a stroke in steps, with a random budget for each and poses added between them.
StrokeProgress cut_in_steps(World& world, const Stroke& stroke, const CutSettings& settings,
                            std::mt19937& random) {
  Stroke begin = stroke;
  begin.keys.resize(1 + random() % stroke.keys.size());
  world.begin_stroke(begin, settings);
  size_t next = begin.keys.size();
  bool ended = false;
  for (;;) {
    const StrokeProgress progress = world.step_stroke(1 + random() % 2000, random() % 2 ? kNoTime : 1e-4);
    if (progress.is_finished) return progress;
    if (!progress.is_idle && random() % 4 > 0) continue;
    if (next < stroke.keys.size()) {
      world.add_pose(stroke.keys[next++]);
    } else if (!ended) {
      world.end_stroke();
      ended = true;
    }
  }
}

// What a client sees of a world.
std::string state_of(const World& world) {
  std::string state = world.hash() + world.graph();
  for (const Mesh& piece : world.pieces()) {
    state += piece.name();
    for (const double x : piece.vertices()) state += std::to_string(std::bit_cast<uint64_t>(x)) + " ";
    for (const uint32_t v : piece.faces()) state += std::to_string(v) + " ";
  }
  return state;
}

World world_of(const Mesh& mesh) {
  World world;
  world.add(mesh);
  return world;
}

TEST(StrokeSteps, result_does_not_depend_on_the_division) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    CutSettings settings;
    settings.rim = seed % 2 ? KERF_RIM_SMOOTH : KERF_RIM_FACES;
    if (seed % 6 == 0) settings.model = KERF_MODEL_THERMAL;
    World whole = world_of(sheet(30)), steps = world_of(sheet(30));
    for (int i = 0; i < 3; ++i) {
      const Stroke stroke = random_stroke(random);
      const CutResult wanted = whole.cut(stroke, settings);
      const StrokeProgress done = cut_in_steps(steps, stroke, settings, random);
      EXPECT_EQ(done.removed_faces, wanted.removed_faces);
      EXPECT_NEAR(done.removed_area, wanted.removed_area, 1e-12);
      ASSERT_EQ(state_of(steps), state_of(whole));
    }
  }
}

TEST(StrokeSteps, cancel_restores_the_world) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const CutSettings settings{.rim = seed % 2 ? KERF_RIM_SMOOTH : KERF_RIM_FACES};
    World world = world_of(sheet(20));
    world.cut(random_stroke(random), settings);
    const std::string before = state_of(world);
    const Stroke stroke = random_stroke(random);
    world.begin_stroke(stroke, settings);
    if (seed % 3 > 0) world.end_stroke();
    for (unsigned i = 0; i < 4 * seed; ++i) {
      if (world.step_stroke(0, 0).is_idle) break;
    }
    try {
      world.cancel_stroke();
    } catch (const InvalidArgument&) {  // it was finished
      continue;
    }
    EXPECT_EQ(state_of(world), before);
    World copy = world_of(sheet(20));
    std::mt19937 again(seed);
    copy.cut(random_stroke(again), settings);
    const Stroke next = random_stroke(again);
    world.cut(next, settings);
    copy.cut(next, settings);
    EXPECT_EQ(state_of(world), state_of(copy));
    const std::string file = testing::TempDir() + "kerf-cancelled.kerf";
    world.save_journal(file);
    EXPECT_EQ(World(file).hash(), world.hash());
  }
}

TEST(StrokeSteps, a_budget_of_faces_divides_the_work) {
  World world = world_of(sheet(100));
  world.begin_stroke(through_the_middle());
  size_t steps = 0, largest = 0;
  world.end_stroke();
  for (;; ++steps) {
    const StrokeProgress progress = world.step_stroke(500, kNoTime);
    largest = std::max(largest, progress.faces);
    if (progress.is_finished) break;
  }
  EXPECT_GT(steps, 5u);
  EXPECT_LT(largest, 2000u);
}

TEST(StrokeSteps, other_changes_wait_for_the_end) {
  World world = world_of(sheet(10));
  EXPECT_THROW(world.step_stroke(1, 1), InvalidArgument);
  EXPECT_THROW(world.end_stroke(), InvalidArgument);
  EXPECT_THROW(world.cancel_stroke(), InvalidArgument);
  world.begin_stroke(through_the_middle());
  EXPECT_THROW(world.begin_stroke(through_the_middle()), Busy);
  EXPECT_THROW(world.cut(through_the_middle()), Busy);
  EXPECT_THROW(world.add(sheet(1)), Busy);
  EXPECT_THROW(world.add_pose({0.5, {0, 0, 0}, {0, -1, 0}}), InvalidArgument);  // an earlier time
  EXPECT_THROW(world.add_pose({2, {0, 0, 0}, {0, 1, 0}}), InvalidArgument);     // opposite
  EXPECT_THROW(world.step_stroke(1, -1), InvalidArgument);
  world.end_stroke();
  EXPECT_THROW(world.add_pose({3, {0, 0, 0}, {0, -1, 0}}), InvalidArgument);
  EXPECT_THROW(world.end_stroke(), InvalidArgument);
  EXPECT_TRUE(world.step_stroke(kNoFaces, kNoTime).is_finished);
  EXPECT_EQ(world.pieces().size(), 2u);
}

}  // namespace
}  // namespace kerf::test
