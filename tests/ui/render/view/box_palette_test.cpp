#include "ui/render/view/colours.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace kerf {
namespace {

// Rows as printed: G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, A Physiologically-based Model for
// Simulation of Color Vision Deficiency, 2009, table at severity 1.0; linear RGB.
glm::dmat3 rows(const glm::dvec3& r, const glm::dvec3& g, const glm::dvec3& b) {
  return glm::transpose(glm::dmat3(r, g, b));
}
const glm::dmat3 kProtan =
    rows({0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998});
const glm::dmat3 kDeutan =
    rows({0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881});
const glm::dmat3 kTritan =
    rows({1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900});
const glm::dmat3 kNormal(1);

glm::dvec3 linear(uint32_t hex) {
  glm::dvec3 c;
  for (int i = 0; i < 3; ++i) {
    const double x = (hex >> (16 - 8 * i) & 255u) / 255.0;
    c[i] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  }
  return c;
}

// CIE L*a*b*, white D65.
glm::dvec3 lab(const glm::dvec3& rgb) {
  const glm::dmat3 xyz = rows({0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750},
                              {0.0193339, 0.1191920, 0.9503041});
  const glm::dvec3 relative = xyz * glm::clamp(rgb, 0.0, 1.0) / glm::dvec3(0.95047, 1, 1.08883);
  glm::dvec3 f;
  for (int i = 0; i < 3; ++i) {
    f[i] = relative[i] > 216.0 / 24389 ? std::cbrt(relative[i]) : (24389.0 / 27 * relative[i] + 16) / 116;
  }
  return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

double cie76(const BoxColours& c, const glm::dmat3& sight) {
  return glm::length(lab(sight * linear(c.hit)) - lab(sight * linear(c.untouched)));
}

TEST(BoxPalette, orange_and_blue_are_distinct_for_every_colour_vision) {
  const BoxColours colours = colours_of(BoxPalette::kOrangeAndBlue);
  for (const auto& [name, sight] : {std::pair("normal", kNormal), std::pair("protan", kProtan),
                                    std::pair("deutan", kDeutan), std::pair("tritan", kTritan)}) {
    const double apart = cie76(colours, sight);
    RecordProperty(name, std::to_string(apart));
    EXPECT_GE(apart, 40) << name;
  }
}

TEST(BoxPalette, red_and_green_are_distinct_for_full_colour_vision) {
  const BoxColours colours = colours_of(BoxPalette::kRedAndGreen);
  EXPECT_GE(cie76(colours, kNormal), 40);
  EXPECT_GE(cie76(colours, kTritan), 40);
}

}  // namespace
}  // namespace kerf
