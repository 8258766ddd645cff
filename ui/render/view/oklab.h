#pragma once

#include <functional>
#include <glm/glm.hpp>

namespace kerf {

// Colours in OKLab, where equal distances look equally different (B. Ottosson: A perceptual color space for
// image processing, 2020): lightness from 0 to 1, then green to red, then blue to yellow.

glm::dvec3 oklab_from_linear(const glm::dvec3& rgb);
// Clamps colours that a screen does not have.
glm::dvec3 linear_from_oklab(const glm::dvec3& lab);
// A colour of this hue (degrees).
glm::dvec3 oklab_of(double lightness, double chroma, double hue);

// Linear light in sRGB, 0 .. 1.
glm::dvec3 screen_from_linear(const glm::dvec3& rgb);

// A path through OKLab for s = 0 .. 1.
using OklabPath = std::function<glm::dvec3(double s)>;
// The linear light of the path at the fraction t of its length, so that equal steps of t look equally large.
glm::dvec3 linear_along(const OklabPath& path, double t);

}  // namespace kerf
