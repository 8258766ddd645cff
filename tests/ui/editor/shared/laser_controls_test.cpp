#include "ui/editor/shared/laser_controls.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(LaserControls, add_heat_to_a_geometric_cut_unless_disabled) {
  LaserControls laser;
  laser.radius = 0.006;
  EXPECT_DOUBLE_EQ(laser.settings(5).heat_width, 0.012);
  laser.radius = 0.024;
  EXPECT_DOUBLE_EQ(laser.settings(5).heat_width, 0.024);
  laser.radius = 0.0002;
  EXPECT_DOUBLE_EQ(laser.settings(5).heat_width, 0.0016);
  laser.metre = 1000;
  laser.radius = 0.2;
  EXPECT_DOUBLE_EQ(laser.settings(5000).heat_width, 1.6);
  laser.radius = 6;
  EXPECT_DOUBLE_EQ(laser.settings(5000).heat_width, 12);
  laser.heat_width = 0.001;
  EXPECT_EQ(laser.settings(5).heat_width, 0.001);
  laser.heat_width = 0;
  EXPECT_EQ(laser.settings(5).heat_width, 0);
}

TEST(LaserControls, fit_resets_lengths_typed_for_another_file) {
  LaserControls laser;
  laser.radius = 0.006;
  laser.heat_width = 0;
  laser.fit(2000);
  EXPECT_EQ(laser.radius, 5);
  EXPECT_EQ(laser.width_of_heat(), laser.standard_width_of_heat());
}

TEST(LaserControls, thermal_model_has_power_and_always_deposits_heat) {
  LaserControls laser;
  laser.model = Model::kThermal;
  laser.power = 350;
  const CutSettings settings = laser.settings(5);
  EXPECT_EQ(settings.model, Model::kThermal);
  EXPECT_EQ(settings.laser.power, 350);
  EXPECT_EQ(settings.heat_width, 0);
}

TEST(LaserControls, show_the_radius_and_the_resolution_of_a_stroke) {
  LaserControls drawn, shown;
  drawn.fit(4);
  shown.fit(4);
  drawn.radius *= 2;
  for (const auto rule :
       {Resolution::Rule::kTargetEdge, Resolution::Rule::kTolerance, Resolution::Rule::kDepth}) {
    drawn.resolution = {.scheme = Scheme::kOneToFour,
                        .rule = rule,
                        .edge_fraction = 0.5,
                        .tolerance_fraction = 1,
                        .depth = 7,
                        .rim = Rim::kFaces};
    shown.show(drawn.settings(4));
    EXPECT_EQ(shown.radius, drawn.radius);
    EXPECT_EQ(shown.resolution.rule, rule);
  }
  EXPECT_EQ(shown.settings(4).resolution, drawn.settings(4).resolution);
}

}  // namespace
}  // namespace kerf
