#include "ui/render/passes/beam_effects.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(BeamPass, limits_the_impact_spot_to_a_fifth_of_the_image_height) {
  for (const int height : {1, 16, 100, 169, 170, 171, 800, 2160}) {
    for (const double radius : {0.0, 0.5, 2.0, 10.0, 1e6}) {
      const double half_width = spot_half_width(radius, height);
      EXPECT_GT(half_width, 0) << height << ' ' << radius;
      EXPECT_LE(half_width, 0.2 * height) << height << ' ' << radius;
    }
  }
}

TEST(BeamPass, keeps_the_spot_of_a_thin_beam_visible) {
  EXPECT_EQ(spot_half_width(0.5, 800), 34);
  EXPECT_EQ(spot_half_width(5, 800), 80);
}

}  // namespace
}  // namespace kerf
