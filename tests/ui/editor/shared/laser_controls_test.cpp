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

TEST(LaserControls, leave_a_stroke_the_laser_settings_of_its_file) {
  LaserControls laser;
  laser.model = Model::kThermal;
  StrokePath stroke;
  stroke.radius = 0.0002;
  stroke.power = 350;
  stroke.range = Interval{0, 2};
  stroke.wavelength = 10.6e-6;
  stroke.focus = 0.15;
  stroke.pulse_rate = 500;
  stroke.duty = 0.4;
  stroke.keys = {{{0, 1, 0}, {0, -1, 0}}, {{1, 1, 0}, {0, -1, 0}}};
  stroke.times = {0, 1};
  const std::vector<Command> commands = laser.commands_of(std::span(&stroke, 1), 5, false);
  const auto* begin = std::get_if<BeginStroke>(&commands.front());
  ASSERT_NE(begin, nullptr);
  const Laser expected = default_settings(stroke, 5).laser;
  const Laser& cut = begin->settings.laser;
  EXPECT_EQ(cut.radius, expected.radius);
  EXPECT_EQ(cut.power, expected.power);
  EXPECT_EQ(cut.range.high, expected.range.high);
  EXPECT_EQ(cut.wavelength, expected.wavelength);
  EXPECT_EQ(cut.focus, expected.focus);
  EXPECT_EQ(cut.pulse_rate, expected.pulse_rate);
  EXPECT_EQ(cut.duty, expected.duty);
}

TEST(LaserControls, leave_a_stroke_of_radius_zero_to_the_knife) {
  LaserControls laser;
  laser.model = Model::kThermal;
  StrokePath stroke;
  stroke.radius = 0;
  stroke.keys = {{{0, 1, 0}, {0, -1, 0}}, {{1, 1, 0}, {0, -1, 0}}};
  stroke.times = {0, 1};
  const std::vector<Command> commands = laser.commands_of(std::span(&stroke, 1), 5, false);
  ASSERT_EQ(commands.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<CutPath>(commands.front()));
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
