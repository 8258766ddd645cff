#include "ui/render/view/colours.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kerf {
namespace {

double apart(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::distance(oklab_from_linear(a), oklab_from_linear(b));
}

TEST(PiecePalette, the_first_colours_differ_from_paints_and_each_other) {
  const std::vector<glm::dvec3> paints{{0.03, 0.10, 0.35}, {0.02, 0.02, 0.02}, {0.10, 0.35, 0.30}};
  const std::vector<glm::dvec3> colours = piece_palette(paints, 6);
  ASSERT_EQ(colours.size(), 6u);
  for (size_t i = 0; i < colours.size(); ++i) {
    for (const glm::dvec3& paint : paints) EXPECT_GT(apart(colours[i], paint), 0.08) << i;
    for (size_t j = 0; j < i; ++j) EXPECT_GT(apart(colours[i], colours[j]), 0.08) << i << " and " << j;
  }
}

TEST(PiecePalette, the_first_colour_contrasts_with_the_body) {
  const auto hue = [](const glm::dvec3& paint) {
    const glm::dvec3 lab = oklab_from_linear(piece_palette(std::span(&paint, 1), 1).front());
    return lab.z;  // blue is negative
  };
  EXPECT_GT(hue({0.03, 0.10, 0.45}), 0);
  EXPECT_LT(hue({0.03, 0.35, 0.05}), 0);
}

TEST(PiecePalette, longer_palettes_begin_with_the_same_colours) {
  const glm::dvec3 paint(0.2);
  const auto few = piece_palette(std::span(&paint, 1), 3), many = piece_palette(std::span(&paint, 1), 32);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

}  // namespace
}  // namespace kerf
