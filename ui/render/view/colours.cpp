#include "ui/render/view/colours.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/deterministic_math.h"

namespace kerf {

namespace {

// Returns the position on the path at the fraction t of its length.
double even_place(const OklabPath& path, double t) {
  constexpr int kParts = 256;
  std::array<double, kParts + 1> length{};
  for (size_t i = 1; i <= kParts; ++i) {
    const double s = static_cast<double>(i) / kParts;
    length[i] = length[i - 1] + glm::distance(path(s), path(s - 1.0 / kParts));
  }
  const double wanted = std::clamp(t, 0.0, 1.0) * length.back();
  const auto above = std::max(std::lower_bound(length.begin(), length.end(), wanted), length.begin() + 1);
  const auto below = above - 1;
  return (static_cast<double>(below - length.begin()) + (wanted - *below) / (*above - *below)) / kParts;
}

constexpr double kFirstHue = 120, kLastHue = 350, kHueStep = 10;  // degrees: from green over blue to pink

// A candidate colour, and its distance from the colours in use.
struct Candidate {
  glm::dvec3 lab;
  double apart = std::numeric_limits<double>::infinity();
};

std::vector<Candidate> all_candidates() {
  std::vector<Candidate> all;
  for (double hue = kFirstHue; hue <= kLastHue; hue += kHueStep) {
    for (const double lightness : {0.42, 0.52, 0.62}) {
      for (const double chroma : {0.05, 0.10}) all.push_back({oklab_of(lightness, chroma, hue)});
    }
  }
  return all;
}

void keep_away(std::vector<Candidate>& all, const glm::dvec3& lab) {
  for (Candidate& c : all) c.apart = std::min(c.apart, glm::distance(c.lab, lab));
}

}  // namespace

glm::dvec3 oklab_from_linear(const glm::dvec3& rgb) {
  const double l = std::cbrt(0.4122214708 * rgb.r + 0.5363325363 * rgb.g + 0.0514459929 * rgb.b);
  const double m = std::cbrt(0.2119034982 * rgb.r + 0.6806995451 * rgb.g + 0.1073969566 * rgb.b);
  const double s = std::cbrt(0.0883024619 * rgb.r + 0.2817188376 * rgb.g + 0.6299787005 * rgb.b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

glm::dvec3 linear_from_oklab(const glm::dvec3& lab) {
  const double l = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
  const double m = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
  const double s = lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z;
  const double l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  const glm::dvec3 rgb(4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3,
                       -1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3,
                       -0.0041960863 * l3 - 0.7034186147 * m3 + 1.7076147010 * s3);
  return glm::clamp(rgb, 0.0, 1.0);
}

glm::dvec3 oklab_of(double lightness, double chroma, double hue) {
  const double turned = hue * kPi / 180;
  return {lightness, chroma * std::cos(turned), chroma * std::sin(turned)};
}

glm::dvec3 screen_from_linear(const glm::dvec3& rgb) {
  glm::dvec3 screen;
  for (int i = 0; i < 3; ++i)
    screen[i] = rgb[i] <= 0.0031308 ? 12.92 * rgb[i] : 1.055 * std::pow(rgb[i], 1 / 2.4) - 0.055;
  return screen;
}

glm::dvec3 linear_along(const OklabPath& path, double t) {
  return linear_from_oklab(path(even_place(path, t)));
}

std::vector<glm::dvec3> piece_palette(std::span<const glm::dvec3> paints, size_t count) {
  std::vector<Candidate> all = all_candidates();
  for (const glm::dvec3& paint : paints) keep_away(all, oklab_from_linear(paint));
  std::vector<glm::dvec3> palette;
  while (palette.size() < count) {
    const glm::dvec3 lab = std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
                             return a.apart < b.apart;
                           })->lab;
    palette.push_back(linear_from_oklab(lab));
    keep_away(all, lab);
  }
  return palette;
}

}  // namespace kerf
