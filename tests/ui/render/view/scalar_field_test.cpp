#include "ui/render/view/view_options.h"

#include <gtest/gtest.h>

#include "ui/render/view/colours.h"

namespace kerf {
namespace {

constexpr int kSteps = 64;

glm::dvec3 lab_at(int step) {
  return oklab_from_linear(
      linear_scalar_colour(ColourScale::kSequential, static_cast<double>(step) / kSteps));
}

TEST(ScalarColour, lightens_in_perceptually_equal_steps) {
  const double whole = glm::distance(lab_at(0), lab_at(1));
  for (int i = 1; i <= kSteps; ++i) {
    EXPECT_GT(lab_at(i).x, lab_at(i - 1).x) << i;
    EXPECT_NEAR(glm::distance(lab_at(i), lab_at(i - 1)), whole, 0.12 * whole) << i;
  }
}

TEST(ScalarColour, of_a_diverging_scale_darkens_equally_to_both_ends) {
  const auto lab = [](int step) {
    return oklab_from_linear(
        linear_scalar_colour(ColourScale::kDiverging, static_cast<double>(step) / kSteps));
  };
  const double whole = glm::distance(lab(0), lab(1));
  for (int i = 1; i <= kSteps; ++i) {
    EXPECT_NEAR(lab(i).x, lab(kSteps - i).x, 0.01) << i;
    EXPECT_EQ(lab(i).x > lab(i - 1).x, i <= kSteps / 2) << i;
    EXPECT_NEAR(glm::distance(lab(i), lab(i - 1)), whole, 0.12 * whole) << i;
  }
}

TEST(ScalarColour, stays_within_the_screen_gamut) {
  for (const ColourScale scale : {ColourScale::kSequential, ColourScale::kDiverging}) {
    for (int i = 0; i <= kSteps; ++i) {
      const glm::vec3 c = scalar_colour(scale, static_cast<double>(i) / kSteps);
      for (int k = 0; k < 3; ++k) {
        EXPECT_GT(c[k], 0) << i;
        EXPECT_LT(c[k], 1) << i;
      }
    }
  }
}

}  // namespace
}  // namespace kerf
