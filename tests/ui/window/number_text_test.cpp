#include <gtest/gtest.h>

#include "ui/window/number_text.h"

namespace kerf {
namespace {

TEST(NumberText, groups_digits_and_selects_the_area_unit) {
  EXPECT_EQ(grouped(12345678), "12 345 678");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(area_text(0), "none");
  EXPECT_EQ(area_text(6.27), "6.27 m\xc2\xb2");
  EXPECT_EQ(area_text(0.00041), "4.1 cm\xc2\xb2");
}

TEST(NumberText, shows_noise_as_0_without_a_sign) {
  EXPECT_EQ(number_text(-0.0, "%.4g"), "0");
  EXPECT_EQ(number_text(-0.3, "%.0f"), "0");
  EXPECT_EQ(number_text(-0.004, "%.2f m"), "0.00 m");
  EXPECT_EQ(number_text(5.551e-17, "%.4g", 1), "0");
  EXPECT_EQ(number_text(-5.551e-17, "%.4g", -2), "0");
  EXPECT_EQ(number_text(5.551e-17, "%.4g", 1e-16), "5.551e-17");
  EXPECT_EQ(number_text(5.551e-17, "%.4g"), "5.551e-17");
  EXPECT_EQ(number_text(-0.02, "%.2f"), "-0.02");
  EXPECT_EQ(number_text(-1e-20, "%.4g"), "-1e-20");
  EXPECT_EQ(number_text(-0.5, "%.1f m/s"), "-0.5 m/s");
}

}  // namespace
}  // namespace kerf
