#include "core/heat/lumped_cut.h"

#include <gtest/gtest.h>

#include "core/document/material_table.h"
#include "core/heat/material.h"
#include "tests/support/checkout.h"

namespace kerf::test {
namespace {

Substance preset(const std::string& name) {
  const auto materials = load_materials(checkout() / "assets" / "materials.json");
  EXPECT_TRUE(materials.ok()) << materials.error().message;
  return find_material(*materials, name)->substance;
}

// A cut by an even beam with this absorptivity.
LumpedCut cut_with(Substance substance, double lumped, double power, double kerf) {
  substance.absorptivity_fibre = substance.absorptivity_co2 = lumped;
  return {substance, power, 0, kerf, 1};
}

TEST(LumpedCut, speeds_without_conduction_match_the_worked_examples) {
  LumpedCut steel = cut_with(preset("stainless-304"), 0.28, 2000, 0.19e-3);
  steel.substance.conductivity = 0;
  EXPECT_NEAR(cutting_speed(steel, 2e-3), 0.167764, 1e-5);
  LumpedCut acrylic = cut_with(preset("pmma"), 0.9, 54, 0.3e-3);
  acrylic.substance.conductivity = 0;
  EXPECT_NEAR(cutting_speed(acrylic, 6e-3), 6.538e-3, 1e-6);
}

TEST(LumpedCut, speeds_with_conduction_match_the_table) {
  struct Row {
    double thickness, power, kerf, speed;  // mm, W, mm, m/min
  };
  for (const Row& row : {Row{1, 1000, 0.16, 11.5}, Row{2, 2000, 0.19, 9.70}, Row{3, 3000, 0.22, 8.37},
                         Row{5, 4000, 0.26, 5.24}, Row{10, 6000, 0.33, 2.73}}) {
    const LumpedCut cut = cut_with(preset("stainless-304"), 0.42, row.power, 1e-3 * row.kerf);
    EXPECT_NEAR(60 * cutting_speed(cut, 1e-3 * row.thickness), row.speed, 0.015 * row.speed) << row.thickness;
    EXPECT_NEAR(
        60 * cutting_speed({preset("stainless-304"), row.power, 0, 1e-3 * row.kerf}, 1e-3 * row.thickness),
        row.speed, 0.1 * row.speed)
        << row.thickness;
  }
  for (const Row& row : {Row{3, 42, 0.25, 0.742}, Row{6, 54, 0.30, 0.392}, Row{10, 150, 0.40, 0.498}}) {
    const LumpedCut cut = cut_with(preset("pmma"), 0.95, row.power, 1e-3 * row.kerf);
    EXPECT_NEAR(60 * cutting_speed(cut, 1e-3 * row.thickness), row.speed, 0.015 * row.speed) << row.thickness;
  }
}

// Without conduction the balance is linear in the speed above that of the burning front.
TEST(LumpedCut, oxygen_adds_the_heat_of_burning_up_to_the_speed_of_its_front) {
  LumpedCut cut{preset("mild-steel"), 2000, 0, 0.2e-3};
  cut.substance.conductivity = 0;
  const double without = cutting_speed(cut, 1e-3);
  ASSERT_GT(without, 2 * kBurningFront);
  cut.oxygen = true;
  const double heat = cut.substance.burnt_share * kHeatOfBurning;
  const double more = cut.axis * kBurningFront * heat / enthalpy_of_removal(cut.substance);
  EXPECT_NEAR(cutting_speed(cut, 1e-3), without + more, 1e-9 * without);
  cut.substance.burnt_share = 0;
  EXPECT_NEAR(cutting_speed(cut, 1e-3), without, 1e-9 * without);
}

TEST(LumpedCut, oxygen_cuts_steel_that_the_beam_alone_does_not) {
  LumpedCut cut{preset("mild-steel"), 1000, 0, 0.2e-3};
  const double alone = cutting_speed(cut, 3e-3);
  cut.oxygen = true;
  const double together = cutting_speed(cut, 3e-3);
  EXPECT_GT(together, 3 * alone);
  EXPECT_NEAR(cut_thickness(cut, together), 3e-3, 1e-9);
  EXPECT_LT(cut_thickness(cut, 1.01 * together), 3e-3);
  for (double speed = 2 * kBurningFront; speed < 2; speed *= 1.1)
    EXPECT_GT(cut_thickness(cut, speed), cut_thickness(cut, 1.1 * speed));
}

TEST(LumpedCut, thickness_and_speed_are_inverse_and_too_little_power_fails) {
  const LumpedCut cut{preset("mild-steel"), 2000, 0, 0.2e-3};
  for (const double thickness : {0.5e-3, 1e-3, 3e-3}) {
    EXPECT_NEAR(cut_thickness(cut, cutting_speed(cut, thickness)), thickness, 1e-9 * thickness);
  }
  EXPECT_EQ(cutting_speed(cut_with(preset("mild-steel"), 0.7, 1000, 0.35e-3), 10e-3), 0);
}

TEST(LumpedCut, conduction_loss_matches_the_series) {
  EXPECT_DOUBLE_EQ(conduction_loss(0), 1.2902);
  EXPECT_NEAR(conduction_loss(0.5), 3.3245, 1e-9);
  EXPECT_NEAR(conduction_loss(8), 8.0204, 1e-9);
  EXPECT_NEAR(conduction_loss(80), 8.0204 * 2.2909, 1e-3);
  for (double peclet = 0.01; peclet < 100; peclet *= 1.01)
    EXPECT_LT(conduction_loss(peclet), conduction_loss(1.01 * peclet));
}

}  // namespace
}  // namespace kerf::test
