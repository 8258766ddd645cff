#include "core/cut/cut_stages.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/cut/thermal_step.h"
#include "core/document/document.h"
#include "core/world/body_mass.h"
#include "core/world/world.h"
#include "tests/support/energy.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"
#include "tests/support/solids.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

constexpr double kRadius = 0.004, kWidth = 0.008;

// A slot along z in the middle of a sheet in y = 0.
struct Slot {
  World world;
  CutSettings settings;
  std::vector<BeamMove> moves;

  explicit Slot(double target_edge, Rim rim = Rim::kFaces) {
    add(world, rectangle(0.2, 0.2, 4), {0, 0, 0});
    settings.laser.radius = kRadius;
    settings.laser.range = {0, 1};
    settings.heat_width = kWidth;
    settings.resolution.target_edge = target_edge;
    settings.resolution.rim = rim;
    moves = subdivide({{{0, 0.1, -0.05}, {0, -1, 0}}, {{0, 0.1, 0.05}, {0, -1, 0}}, 1}, kRadius, 0.2);
  }

  void cut() {
    ASSERT_TRUE(cut_whole(world, settings, moves).ok());
    if (settings.smooth()) ASSERT_TRUE(close_rim(world, settings, moves).ok());
  }
  const Body& body() const { return world.body(world.ids()[0]); }
};

double temperature(const Body& body, FaceId f) {
  return body.heat.temperature(body.mesh, f, body.sheet.substance, body.sheet.thickness);
}

void close_rim_in_steps(World& world, const CutSettings& settings, std::span<const BeamMove> moves) {
  UnfinishedRim rim;
  do {
    ASSERT_TRUE(rim_step(world, settings, moves, {}, rim).ok());
  } while (rim.begun());
}

// Whether a triangle is not in the faces of a brick of this size at the origin.
bool is_within(const Vec3& size, const Triangle& t) {
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  const auto inside = [](double x, double end) { return x > 1e-9 && x < end - 1e-9; };
  return inside(middle.x, size.x) && inside(middle.y, size.y) && inside(middle.z, size.z);
}

// The mean of the profile over a face, by a fine sum over the face: the expected temperature is that of the
// mean enthalpy, which is linear below the transition.
double expected_temperature(const Triangle& t, const Substance& substance) {
  constexpr int kCells = 24;
  double sum = 0;
  int count = 0;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; i + j < kCells; ++j) {
      const double u = (i + 1.0 / 3) / kCells, v = (j + 1.0 / 3) / kCells;
      const Vec3 p = (1 - u - v) * t[0] + u * t[1] + v * t[2];
      const Vec3 nearest(0, 0, std::clamp(p.z, -0.05, 0.05));
      sum += std::max(0.0, 1 - std::max(0.0, glm::distance(p, nearest) - kRadius) / kWidth);
      ++count;
    }
  }
  return kAmbient + sum / count * (substance.transition - kAmbient);
}

TEST(DepositHeat, reaches_the_melting_point_at_the_rim_and_decays_over_the_width) {
  Slot slot(0.001);
  slot.cut();
  const Body& body = slot.body();
  double hottest_face = 0;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    const double now = temperature(body, FaceId(f));
    EXPECT_NEAR(now, expected_temperature(t, body.sheet.substance), 45) << "face " << f;
    hottest_face = std::max(hottest_face, now);
  }
  EXPECT_GT(hottest_face, 0.95 * body.sheet.substance.transition);
  EXPECT_LE(hottest_face, body.sheet.substance.transition);
  expect_closed_ledger(slot.world, 1e-9);
}

TEST(DepositHeat, creates_no_faces_and_removes_the_same_as_without_heat) {
  for (const Rim rim : {Rim::kFaces, Rim::kSmooth}) {
    Slot with(0.002, rim), without(0.002, rim);
    without.settings.heat_width = 0;
    with.cut();
    without.cut();
    EXPECT_EQ(with.body().mesh.live_faces(), without.body().mesh.live_faces());
    EXPECT_EQ(without.world.energy(), EnergyLedger{});
    EXPECT_FALSE(is_hot(without.world));
  }
}

TEST(DepositHeat, heats_walls_of_a_solid_to_the_melting_point_for_any_step_size) {
  const Vec3 size(0.2, 0.05, 0.2);
  std::vector<uint64_t> hashes;
  for (const bool unsliced : {true, false}) {
    World world = world_of(inside_out(brick(size)));
    const BodyId id = world.ids().front();
    make_solid(world.body(id), true);
    SolidStroke stroke = straight_stroke({0.1, 0.1, -0.1}, {0.1, 0.1, 0.3}, {0, -1, 0}, kRadius, {0, 1});
    stroke.settings.heat_width = kWidth;
    stroke.settings.faces_per_step = 1;
    const std::vector<BeamMove> moves = subdivide({stroke.poses[0], stroke.poses[1], 1}, kRadius, 0.2);
    ASSERT_TRUE(cut_whole(world, stroke.settings, moves).ok());
    if (unsliced) ASSERT_TRUE(close_rim(world, stroke.settings, moves).ok());
    if (!unsliced) close_rim_in_steps(world, stroke.settings, moves);
    const Body& body = world.body(id);
    size_t walls = 0;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f)) || !is_within(size, body.mesh.triangle(FaceId(f)))) continue;
      ++walls;
      EXPECT_NEAR(temperature(body, FaceId(f)), body.sheet.substance.transition, 1e-6);
    }
    EXPECT_GT(walls, 1000);  // more than are heated in one step
    expect_closed_ledger(world, 1e-9);
    hashes.push_back(state_hash(world));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(DepositHeat, does_not_depend_on_the_step_size) {
  for (const Rim rim : {Rim::kFaces, Rim::kSmooth}) {
    Slot whole(0.002, rim), stepped(0.002, rim);
    stepped.settings.faces_per_step = 1;
    whole.cut();
    stepped.cut();
    EXPECT_EQ(state_hash(whole.world), state_hash(stepped.world));
  }
}

TEST(DepositHeat, does_not_heat_a_sheet_the_beam_misses) {
  Slot slot(0.002);
  const BodyId beside = add(slot.world, rectangle(0.05, 0.05, 2), {kRadius + 0.002 + 0.025, 0.001, 0});
  slot.cut();
  EXPECT_EQ(slot.world.body(beside).heat.stored(slot.world.body(beside).mesh), 0);
}

TEST(DepositHeat, does_not_accumulate_when_the_beam_retraces_its_path) {
  Slot slot(0.002);
  slot.cut();
  const double once = slot.body().heat.stored(slot.body().mesh);
  slot.cut();
  EXPECT_NEAR(slot.body().heat.stored(slot.body().mesh), once, 0.02 * once);
}

TEST(DepositHeat, cools_below_visible_glow_in_the_same_time_at_every_resolution) {
  const auto seconds_of_glow = [](double target_edge) {
    Slot slot(target_edge, Rim::kSmooth);
    slot.cut();
    double seconds = 0;
    constexpr double kDraper = 798;
    while (hottest(slot.world) > kDraper && seconds < 100) {
      cool(slot.world, 1.0 / 120);
      seconds += 1.0 / 120;
    }
    return seconds;
  };
  const double expected = seconds_of_glow(kRadius / 4);
  EXPECT_GT(expected, 0.5);
  EXPECT_LT(expected, 60);
  EXPECT_NEAR(seconds_of_glow(kRadius / 2), expected, 0.2 * expected);
  EXPECT_NEAR(seconds_of_glow(kRadius / 8), expected, 0.2 * expected);
}

// Time that passes after a stroke is undone with it, and comes back with it.
TEST(DepositHeat, cools_with_the_clock_and_is_undone_with_its_stroke) {
  Slot slot(0.002, Rim::kSmooth);
  const uint64_t before = state_hash(slot.world);
  Document document(slot.world);
  document.apply(BeginStroke{slot.settings, slot.moves.front().from});
  document.apply(MoveBeam{slot.moves.back().to, 1});
  document.apply(EndStroke{});
  ASSERT_TRUE(run_all(document).ok());
  const double hot = hottest(document.world());
  document.apply(AdvanceTime{240, false});
  ASSERT_TRUE(run_all(document).ok());
  EXPECT_LT(hottest(document.world()), hot - 50);
  const uint64_t after = state_hash(document.world());
  ASSERT_TRUE(document.apply(Command(Undo{})).ok());
  EXPECT_EQ(state_hash(document.world()), before);
  ASSERT_TRUE(document.apply(Command(Redo{})).ok());
  EXPECT_EQ(state_hash(document.world()), after);
}

TEST(DepositHeat, cools_identically_for_any_step_size) {
  const auto hash_after = [](size_t max_ticks) {
    Slot slot(0.002, Rim::kSmooth);
    Document document(slot.world);
    document.apply(BeginStroke{slot.settings, slot.moves.front().from});
    document.apply(MoveBeam{slot.moves.back().to, 1});
    document.apply(EndStroke{});
    EXPECT_TRUE(run_all(document).ok());
    document.apply(AdvanceTime{61, false});
    while (document.waiting() > 0) EXPECT_TRUE(document.step(max_ticks).ok());
    return state_hash(document.world());
  };
  const uint64_t expected = hash_after(64);
  EXPECT_EQ(hash_after(1), expected);
  EXPECT_EQ(hash_after(7), expected);
}

}  // namespace
}  // namespace kerf::test
