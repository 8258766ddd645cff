#include "core/document/stroke_path.h"

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

TEST(StrokeSettings, default_to_values_derived_from_the_diagonal) {
  const CutSettings settings = default_settings({}, 2);
  EXPECT_EQ(settings.laser.radius, 0.005);
  EXPECT_EQ(settings.laser.range.low, 0);
  EXPECT_EQ(settings.laser.range.high, 20);
  EXPECT_EQ(settings.resolution.target_edge, 0.00125);
  EXPECT_EQ(settings.resolution.tolerance, 0.000625);
  EXPECT_EQ(settings.laser.power, Laser().power);
  EXPECT_EQ(settings.laser.wavelength, 0);
  EXPECT_FALSE(settings.laser.focus.has_value());
  EXPECT_EQ(settings.laser.pulse_rate, 0);
  EXPECT_EQ(settings.laser.duty, 1);
}

TEST(StrokeSettings, use_values_given_by_the_stroke) {
  StrokePath stroke;
  stroke.radius = 0.25;
  stroke.range = Interval{1, 3};
  stroke.power = 400;
  stroke.wavelength = 2e-6;
  stroke.focus = 0.5;
  stroke.pulse_rate = 100;
  stroke.duty = 0.75;
  const CutSettings settings = default_settings(stroke, 2);
  EXPECT_EQ(settings.laser.radius, 0.25);
  EXPECT_EQ(settings.laser.range.low, 1);
  EXPECT_EQ(settings.laser.range.high, 3);
  EXPECT_EQ(settings.laser.power, 400);
  EXPECT_EQ(settings.laser.wavelength, 2e-6);
  EXPECT_EQ(settings.laser.focus, 0.5);
  EXPECT_EQ(settings.laser.pulse_rate, 100);
  EXPECT_EQ(settings.laser.duty, 0.75);
  EXPECT_EQ(settings.resolution.target_edge, 0.0625);
}

}  // namespace
}  // namespace kerf::test
