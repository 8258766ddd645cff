#include "core/cut/thermal_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/document/material_table.h"
#include "core/heat/lumped_cut.h"
#include "core/heat/material.h"
#include "core/world/world.h"
#include "tests/support/checkout.h"
#include "tests/support/energy.h"
#include "tests/support/laser_strips.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

CutSettings thermal(double radius, double power) {
  CutSettings settings;
  settings.model = Model::kThermal;
  settings.laser.radius = radius;
  settings.laser.power = power;
  settings.laser.range = {0, 10};
  settings.resolution.target_edge = radius;
  return settings;
}

// A beam that stands still above the origin.
BeamMove drill(double seconds) { return {{{0, 1, 0}, {0, -1, 0}}, {{0, 1, 0}, {0, -1, 0}}, seconds}; }

World plates(std::initializer_list<double> heights) {
  World world;
  for (const double y : heights) add(world, rectangle(0.1, 0.1, 8), {0, y, 0});
  return world;
}

// A stroke that has about the energy to cut what it meets.
RandomStroke random_thermal_stroke(const World& world, Random& random) {
  RandomStroke stroke = random_stroke(world, random, 0.03, random.below(2) == 0);
  stroke.settings.model = Model::kThermal;
  stroke.settings.resolution.scheme = random.below(2) == 0 ? Scheme::kOneToFour : Scheme::kLongestEdge;
  stroke.settings.resolution.target_edge = random.uniform(0.5, 3) * stroke.settings.laser.radius;
  const double needed = 2 * stroke.settings.laser.radius * 0.001 * 7850 * enthalpy_of_removal({}) /
                        Substance{}.absorptivity_fibre;
  double way = 0;
  for (const BeamMove& move : stroke.moves) way += glm::distance(move.from.origin, move.to.origin);
  const double seconds = random.uniform(0.1, 2);
  stroke.settings.laser.power = random.uniform(0.2, 3) * needed * way / seconds;
  for (BeamMove& move : stroke.moves) move.seconds = seconds / static_cast<double>(stroke.moves.size());
  return stroke;
}

TEST(ThermalStep, balances_the_energy_ledger_over_random_strokes) {
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world = world_of(seed % 2 == 0 ? sphere(12, 16, 0.5) : grid(6, 1));
    for (int stroke = 0; stroke < 3; ++stroke) {
      RandomStroke drawn = random_thermal_stroke(world, random);
      if (stroke == 1) {
        drawn.settings.model = Model::kGeometric;
        drawn.settings.heat_width = random.uniform(0.5, 3) * drawn.settings.laser.radius;
      }
      ASSERT_TRUE(cut_whole(world, drawn.settings, drawn.moves).ok());
      while (!is_settled(world)) continue_separation(world, 1000);
      cool(world, random.uniform(0, 3));
      expect_closed_ledger(world, 1e-9);
    }
    EXPECT_GT(world.energy().absorbed, 0);
  }
}

TEST(ThermalStep, does_not_depend_on_the_step_size) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World whole = world_of(sphere(12, 16, 0.5)), stepped = whole;
    RandomStroke stroke = random_thermal_stroke(whole, random);
    ASSERT_TRUE(cut_whole(whole, stroke.settings, stroke.moves).ok());
    stroke.settings.faces_per_step = 1;
    ASSERT_TRUE(cut_whole(stepped, stroke.settings, stroke.moves).ok());
    EXPECT_EQ(state_hash(whole), state_hash(stepped));
    EXPECT_TRUE(whole.energy() == stepped.energy());
  }
}

TEST(ThermalStep, deposits_the_absorbed_share_of_the_power_in_a_sheet) {
  World world = plates({0});
  CutSettings settings = thermal(0.002, 50);
  const BeamMove move = drill(0.01);
  ASSERT_TRUE(cut_whole(world, settings, {&move, 1}).ok());
  const double share = world.body(world.ids()[0]).sheet.substance.absorptivity_fibre;
  EXPECT_NEAR(world.energy().emitted, 0.5, 1e-12);
  EXPECT_NEAR(world.energy().absorbed, 0.5 * share, 1e-12);
  settings.laser.wavelength = 10.6e-6;
  World other = plates({0});
  ASSERT_TRUE(cut_whole(other, settings, {&move, 1}).ok());
  EXPECT_NEAR(other.energy().absorbed, 0.5 * Substance{}.absorptivity_co2, 1e-12);
}

// A strip of steel that a beam crosses at a speed between those at which it parts without and with oxygen.
TEST(ThermalStep, burns_through_mild_steel_in_oxygen_and_records_the_heat) {
  LaserStrip strip{Substance(), 1e-3, 1000, 0.15e-3, 1};
  const LumpedCut balance{strip.substance, strip.power, 0, strip.kerf};
  const double speed = 1.25 * cutting_speed(balance, strip.thickness);
  EXPECT_FALSE(is_in_two(cross(strip, speed)));
  strip.assist = Assist::kOxygen;
  const World world = cross(strip, speed);
  EXPECT_TRUE(is_in_two(world));
  expect_closed_ledger(world, 1e-6);
  const double kerf = 30 * strip.kerf * strip.kerf * strip.thickness * strip.substance.density;
  EXPECT_GT(world.energy().burnt, 0.3 * kerf * burning_heat(strip.substance, speed));
  EXPECT_LT(world.energy().burnt, 1.1 * kerf * burning_heat(strip.substance, speed));
  strip.substance.burnt_share = 0;
  EXPECT_EQ(cross(strip, speed).energy().burnt, 0);
}

TEST(ThermalStep, emits_about_once_per_spacing_of_its_rays) {
  World world = plates({0});
  const CutSettings settings = thermal(0.001, 1);
  const BeamMove move{{{0, 1, 0}, {0, -1, 0}}, {{0.001, 1, 0}, {0, -1, 0}}, 1e-6};
  ASSERT_TRUE(cut_whole(world, settings, {&move, 1}).ok());
  EXPECT_GE(static_cast<double>(world.energy().poses) * bundle_spacing(1), 1);
  EXPECT_LE(world.energy().poses, 10u);
}

TEST(ThermalStep, counts_all_energy_as_escaped_on_a_miss) {
  World world = plates({0});
  BeamMove move = drill(0.1);
  move.from.origin.x = move.to.origin.x = 5;
  ASSERT_TRUE(cut_whole(world, thermal(0.002, 1000), {&move, 1}).ok());
  EXPECT_EQ(world.energy().absorbed, 0);
  EXPECT_NEAR(world.energy().escaped, 100, 1e-9);
  EXPECT_EQ(state_hash(world), state_hash(plates({0})));
}

// The first wall has to be pierced before the second one gets anything; then it is.
// The plate reaches from -0.05 m to 0.05 m.
TEST(ThermalStep, reports_exposure_time_and_penetration_depth_per_face) {
  const auto cut = [](double power, std::vector<BeamMove> moves) {
    World world = plates({0});
    return cut_whole(world, thermal(0.002, power), moves)->statistics;
  };
  const auto across = [](double from, double to, double seconds) {
    return BeamMove{{{from, 1, 0}, {0, -1, 0}}, {{to, 1, 0}, {0, -1, 0}}, seconds};
  };
  EXPECT_EQ(cut(100, {across(0.2, 0.3, 1)}).met_s, 0);
  EXPECT_NEAR(cut(100, {across(-0.1, 0.1, 1)}).met_s, 0.5, 0.08);
  const StepStatistics weak = cut(100, {across(-0.04, 0.04, 1)});
  EXPECT_NEAR(weak.met_s, 1, 1e-9);
  EXPECT_GT(weak.depth_s, 0);
  EXPECT_LT(weak.depth_s, 0.5);
  const StepStatistics weaker = cut(50, {across(-0.04, 0.04, 1)});
  EXPECT_LT(weaker.depth_s, weak.depth_s);
  // It gets through where it goes slowly, and no more once it goes fast.
  const StepStatistics both = cut(4000, {across(-0.04, -0.03, 0.5), across(-0.03, 0.04, 0.02)});
  EXPECT_NEAR(both.depth_s, cut(4000, {across(-0.04, -0.03, 0.5)}).depth_s, 0.5 * 0.02);
}

// Only the outer rays meet the plate, whose faces there are not split before. All faces have the energy that
// removes a strip of them as wide as the kerf, so the rays wait; then that is a share of what the parts need.
TEST(ThermalStep, counts_the_depth_in_faces_that_are_split_for_waiting_rays) {
  constexpr double kBeam = 0.002, kCell = 0.1 / 8, kPart = 2 * kBeam / kCell;
  World world = plates({0});
  Body& body = world.body(world.ids()[0]);
  const double of_area =
      body.sheet.thickness * body.sheet.substance.density * enthalpy_of_removal(body.sheet.substance);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const double area = triangle_area(body.mesh.triangle(FaceId(f)));
    body.heat.set_energy(body.mesh, FaceId(f), kPart * of_area * area);
  }
  BeamMove move = drill(1e-6);
  move.from.origin.x = move.to.origin.x = 0.05 + 1.55 * kBeam;
  const auto cut = cut_whole(world, thermal(kBeam, 2000), {&move, 1});
  ASSERT_TRUE(cut.ok());
  EXPECT_GT(cut->statistics.faces_made, 0u);
  EXPECT_NEAR(cut->statistics.met_s, move.seconds, 1e-15);
  EXPECT_NEAR(cut->statistics.depth_s, kPart * move.seconds, 0.01 * move.seconds);
}

TEST(ThermalStep, pierces_the_first_wall_before_it_heats_the_second) {
  const CutSettings settings = thermal(0.001, 3000);
  bool shielded = false, pierced = false;
  World world = plates({0, -0.05});
  const Body& first = world.body(world.ids()[0]);
  const Body& second = world.body(world.ids()[1]);
  for (int i = 0; i < 600; ++i) {
    const BeamMove move = drill(0.002);
    ASSERT_TRUE(cut_whole(world, settings, {&move, 1}).ok());
    const bool hole = first.mesh.live_faces() > 0 && first.ejected > 0;
    const bool heated = second.heat.stored(second.mesh) > 0;
    if (!hole) {
      ASSERT_FALSE(heated);
      EXPECT_EQ(second.mesh.live_faces(), 128u) << "refined behind a wall that stands";
      shielded = true;
    }
    pierced |= second.ejected > 0;
  }
  EXPECT_TRUE(shielded && pierced);
  expect_closed_ledger(world, 1e-9);
}

// What a slot takes is decided by power and speed, not by how often the pointer is read.
TEST(ThermalStep, cuts_the_same_length_at_any_input_rate) {
  const auto length_of_cut = [](double seconds_a_move) {
    World world = plates({0});
    CutSettings settings = thermal(0.001, 4000);
    const double speed = 0.04, way = 0.06;
    const int moves = static_cast<int>(std::round(way / speed / seconds_a_move));
    for (int i = 0; i < moves; ++i) {
      const double from = -0.03 + way * i / moves, to = -0.03 + way * (i + 1) / moves;
      const BeamMove move{{{0, 1, from}, {0, -1, 0}}, {{0, 1, to}, {0, -1, 0}}, way / speed / moves};
      const std::vector<BeamMove> parts = subdivide(move, settings.laser.radius, 1);
      EXPECT_TRUE(cut_whole(world, settings, parts).ok());
    }
    return world.body(world.ids()[0]).ejected;
  };
  const double expected = length_of_cut(0.008);
  EXPECT_GT(expected, 0);
  for (const double seconds : {0.004, 0.016, 0.033})
    EXPECT_NEAR(length_of_cut(seconds), expected, 0.02 * expected);
}

TEST(ThermalStep, has_a_speed_of_power_over_thickness_without_conduction) {
  Substance cold;
  cold.conductivity = 0;
  const LaserStrip one{cold, 0.002, 1000, 2e-4, 1};
  LaserStrip twice = one, thick = one;
  twice.power = 2000;
  thick.thickness = 0.004;
  const double speed = fastest_cut(one, 0.01, 0.1);
  EXPECT_NEAR(fastest_cut(twice, 0.01, 2 * speed), 2 * speed, 0.05 * speed);
  EXPECT_NEAR(fastest_cut(thick, 0.01, 0.5 * speed), 0.5 * speed, 0.02 * speed);
}

// The forecast of the lumped balance, which parts the sheet where the axis of the beam has passed.
TEST(ThermalStep, cuts_at_about_the_speed_predicted_by_the_lumped_balance) {
  Substance cold;
  cold.conductivity = 0;
  for (const Substance& substance : {cold, Substance{}}) {
    const LaserStrip strip{substance, 0.001, 2000, 2e-4, 1};
    const double forecast = cutting_speed({substance, strip.power, 0, strip.kerf}, strip.thickness);
    EXPECT_NEAR(fastest_cut(strip, 0.01, forecast), forecast, 0.2 * forecast);
  }
}

TEST(ThermalStep, scales_the_removal_energy_if_faces_cannot_be_split) {
  CutSettings settings = thermal(0.001, 2000);
  EXPECT_FALSE(scales_removal(settings));
  settings.resolution.rule = Resolution::Rule::kDepth;
  settings.resolution.depth = 0;
  EXPECT_TRUE(scales_removal(settings));
  World world;
  add(world, rectangle(0.1, 0.1, 5), {0, 0, 0});  // triangles of 0.02 m
  std::vector<BeamMove> moves;
  for (int i = 0; i < 80; ++i) moves.push_back(drill(0.02));
  ASSERT_TRUE(cut_whole(world, settings, moves).ok());
  const Body& body = world.body(world.ids()[0]);
  const size_t removed = 50 - body.mesh.live_faces();
  ASSERT_GT(removed, 0u);
  const double whole = 0.0002 * body.sheet.thickness * 7850 * enthalpy_of_removal({});
  const double scaled = whole * 0.002 / std::sqrt(0.0004);
  EXPECT_NEAR(body.ejected, static_cast<double>(removed) * scaled, 0.01 * scaled);
  expect_closed_ledger(world, 1e-9);
}

// Published speeds for stainless steel under nitrogen and for acrylic, with the presets, whose absorptivity
// is one for each class of material.
// Faces that are wide and behind others, or beside what is split, take all the energy that a ray has left.
TEST(ThermalStep, removes_no_more_than_its_energy_allows_at_any_power) {
  for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
    World world = world_of(moved(brick({10, 0.2, 10}), {-5.1, 0, -4.7}, 1));
    CutSettings settings = thermal(0.002, 1e12);
    settings.resolution.scheme = scheme;
    const BeamMove move = drill(0.1);
    const auto cut = cut_whole(world, settings, {&move, 1});
    ASSERT_TRUE(cut.ok());
    const double needed = cut->delta.removed_mass * enthalpy_of_removal(Substance{});
    EXPECT_GT(needed, 0);
    EXPECT_LE(needed, world.energy().absorbed * (1 + 1e-9));
    EXPECT_LT(cut->delta.removed_area, 2 * 0.02 * 0.02);
    expect_closed_ledger(world, 1e-9);
  }
}

TEST(ThermalStep, cuts_stainless_steel_and_acrylic_at_published_speeds_within_30_percent) {
  const auto materials = load_materials(checkout() / "assets" / "materials.json");
  ASSERT_TRUE(materials.ok()) << materials.error().message;
  const Substance stainless = find_material(*materials, "stainless-304")->substance;
  const Substance acrylic = find_material(*materials, "pmma")->substance;
  struct Row {
    const Substance& substance;
    double millimetres, watts, metres_a_minute, kerf_in_millimetres;
  };
  for (const Row& row :
       {Row{stainless, 1, 1000, 12, 0.16}, Row{stainless, 2, 2000, 11, 0.19},
        Row{stainless, 3, 3000, 8, 0.22}, Row{stainless, 5, 4000, 5.5, 0.26},
        Row{stainless, 10, 6000, 2.8, 0.33}, Row{acrylic, 3, 42, 0.75, 0.25}, Row{acrylic, 6, 54, 0.39, 0.30},
        Row{acrylic, 3, 100, 1.5, 0.25}, Row{acrylic, 10, 150, 0.6, 0.40}, Row{acrylic, 8, 80, 0.3, 0.35}}) {
    SCOPED_TRACE(std::to_string(row.millimetres) + " mm, " + std::to_string(row.watts) + " W");
    const LaserStrip strip{row.substance, 0.001 * row.millimetres, row.watts, 0.001 * row.kerf_in_millimetres,
                           1};
    const double published = row.metres_a_minute / 60;
    EXPECT_TRUE(is_in_two(cross(strip, 0.7 * published)));
    EXPECT_FALSE(is_in_two(cross(strip, 1.3 * published)));
  }
}

}  // namespace
}  // namespace kerf::test
