#include "ui/render/passes/heat_colours.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/heat/black_body.h"
#include "core/heat/material.h"

namespace kerf {
namespace {

double brightness(const glm::vec3& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

glm::dvec3 oklab(const glm::vec3& screen) {
  glm::dvec3 c;
  for (int i = 0; i < 3; ++i) {
    const double x = screen[i];
    c[i] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  }
  const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
  const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
  const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

TEST(ShownGlow, begins_at_the_draper_point_and_brightens) {
  EXPECT_EQ(shown_glow(kAmbient), glm::vec3(0));
  EXPECT_EQ(shown_glow(kGlowFrom), glm::vec3(0));
  double last = 0;
  for (double t = kGlowFrom + 10; t < 2100; t += 10) {
    const double now = brightness(shown_glow(t));
    EXPECT_GT(now, last) << t;
    last = now;
  }
}

TEST(ShownGlow, runs_from_red_over_orange_to_nearly_white) {
  const glm::vec3 cherry = shown_glow(1000), orange = shown_glow(1500), molten = shown_glow(1800);
  EXPECT_LT(cherry.g, 0.05 * cherry.r);
  EXPECT_GT(orange.g, 0.15 * orange.r);
  EXPECT_LT(orange.b, 0.6 * orange.g);
  EXPECT_GT(molten.g, 0.45 * molten.r);
  EXPECT_GT(molten.b, 0.2 * molten.r);
}

TEST(HeatColour, changes_evenly_and_brightens_monotonically) {
  constexpr int kSteps = 32;
  double least = 1, most = 0, lightness = 0;
  for (int i = 0; i < kSteps; ++i) {
    const glm::dvec3 a = oklab(heat_colour(static_cast<double>(i) / kSteps));
    const glm::dvec3 b = oklab(heat_colour((i + 1.0) / kSteps));
    least = std::min(least, glm::distance(a, b));
    most = std::max(most, glm::distance(a, b));
    EXPECT_GT(b.x, lightness) << i;
    lightness = b.x;
  }
  EXPECT_LT(most, 1.6 * least);
}

TEST(Tint, increases_with_heat_and_stays_below_opaque) {
  EXPECT_EQ(tint_of(kAmbient).a, 0);
  EXPECT_GT(tint_of(560).a, 0.3);
  EXPECT_LT(tint_of(1800).a, 0.95);
}

}  // namespace
}  // namespace kerf
