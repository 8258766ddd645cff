#include "core/heat/black_body.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf::test {
namespace {

// Black bodies through the CIE 1931 table at 1 nm: colour as linear sRGB over its largest component, cd/m^2.
struct Reference {
  double temperature;
  Vec3 colour;
  double luminance;
};
const std::vector<Reference> kReferences = {
    {798, {1, -0.0376, -0.0152}, 7.528e-3},  {900, {1, -0.0148, -0.0175}, 2.002e-1},
    {1000, {1, 0.00861, -0.01957}, 2.687},   {1200, {1, 0.05754, -0.02214}, 1.393e2},
    {1500, {1, 0.13300, -0.01967}, 7.740e3}, {1811, {1, 0.21068, -0.00618}, 1.277e5},
    {2000, {1, 0.25671, 0.00811}, 4.638e5},  {2500, {1, 0.37211, 0.06749}, 5.624e6},
    {3000, {1, 0.47682, 0.15369}, 3.022e7},  {3134, {1, 0.50299, 0.18041}, 4.338e7}};

TEST(BlackBody, colour_and_luminance_match_the_table) {
  for (const Reference& reference : kReferences) {
    const Glow glow = glow_at(reference.temperature);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(glow.colour[i], std::max(0.0, reference.colour[i]), 1e-4)
          << reference.temperature << " " << i;
    EXPECT_NEAR(std::exp(glow.log_luminance), reference.luminance, 2e-3 * reference.luminance)
        << reference.temperature;
  }
}

TEST(BlackBody, nothing_glows_below_the_draper_point) {
  EXPECT_EQ(glow_at(797.9).colour, Vec3(0));
  EXPECT_EQ(glow_at(293).colour, Vec3(0));
  EXPECT_GT(glow_at(798).colour.x, 0);
}

TEST(BlackBody, becomes_brighter_and_whiter_up_to_the_hottest_glow) {
  std::vector<Glow> table;
  for (int i = 0; i < 256; ++i) table.push_back(glow_at(kGlowFrom + i / 255.0 * (kGlowTo - kGlowFrom)));
  EXPECT_EQ(table.back().colour, glow_at(1e5).colour);
  for (size_t i = 1; i < table.size(); ++i) {
    EXPECT_GT(table[i].log_luminance, table[i - 1].log_luminance);
    EXPECT_GE(table[i].colour.y, table[i - 1].colour.y);
    EXPECT_GE(table[i].colour.z, table[i - 1].colour.z);
    EXPECT_EQ(table[i].colour.x, 1);
  }
}

}  // namespace
}  // namespace kerf::test
