#include "ui/render/view/colours.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Oklab, round_trips) {
  for (const glm::dvec3& rgb : {glm::dvec3(0.2, 0.4, 0.8), glm::dvec3(1, 0.1, 0), glm::dvec3(0.01)}) {
    const glm::dvec3 back = linear_from_oklab(oklab_from_linear(rgb));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(back[i], rgb[i], 1e-6);
  }
}

TEST(Oklab, white_has_maximum_lightness_and_no_hue) {
  const glm::dvec3 white = oklab_from_linear(glm::dvec3(1));
  EXPECT_NEAR(white.x, 1, 1e-6);
  EXPECT_NEAR(white.y, 0, 1e-6);
  EXPECT_NEAR(white.z, 0, 1e-6);
}

TEST(Oklab, a_path_is_sampled_evenly_for_any_parametrisation) {
  const auto path = [](double s) { return glm::dvec3(0.2 + 0.6 * s * s, 0, 0); };
  for (const double t : {0.0, 0.25, 0.5, 1.0})
    EXPECT_NEAR(oklab_from_linear(linear_along(path, t)).x, 0.2 + 0.6 * t, 1e-3);
}

}  // namespace
}  // namespace kerf
