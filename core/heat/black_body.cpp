#include "core/heat/black_body.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/exponential.h"
#include "core/heat/colour_matching.h"

namespace kerf {
namespace {

constexpr double kSecondRadiation = 1.438776877e-2;  // m K, Planck's h c / k

// Spectral radiance at a wavelength (m) but for a constant factor.
double planck(double wavelength, double temperature) {
  const double squared = wavelength * wavelength;
  return 1e-30 /
         (squared * squared * wavelength * (exponential(kSecondRadiation / (wavelength * temperature)) - 1));
}

Vec3 tristimulus(double temperature) {
  Vec3 sum(0);
  double wavelength = kMatchedFrom;
  for (const auto& matching : kColourMatching) {
    sum += planck(1e-9 * wavelength, temperature) * Vec3(matching[0], matching[1], matching[2]);
    wavelength += kMatchedStep;
  }
  return sum;
}

// From CIE XYZ to linear sRGB with the white D65 (IEC 61966-2-1).
Vec3 linear_srgb(const Vec3& xyz) {
  return {glm::dot(Vec3(3.2404542, -1.5371385, -0.4985314), xyz),
          glm::dot(Vec3(-0.9692660, 1.8760108, 0.0415560), xyz),
          glm::dot(Vec3(0.0556434, -0.2040259, 1.0572252), xyz)};
}

double fitted_log_luminance(double temperature) {
  const double u = 1000 / temperature;
  return 25.861105 + u * (-26.518044 + u * (1.913252 + u * -0.267061));
}

}  // namespace

Glow glow_at(double temperature) {
  const double seen = std::clamp(temperature, kGlowFrom, kGlowTo);
  if (temperature < kGlowFrom) return {Vec3(0), fitted_log_luminance(seen)};
  const Vec3 rgb = linear_srgb(tristimulus(seen));
  const double largest = std::max({rgb.x, rgb.y, rgb.z});
  return {{std::max(0.0, rgb.x / largest), std::max(0.0, rgb.y / largest), std::max(0.0, rgb.z / largest)},
          fitted_log_luminance(seen)};
}

std::vector<Glow> glow_table(size_t entries) {
  KERF_ASSERT(entries > 1);
  std::vector<Glow> table;
  table.reserve(entries);
  for (size_t i = 0; i < entries; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(entries - 1);
    table.push_back(glow_at(kGlowFrom + share * (kGlowTo - kGlowFrom)));
  }
  return table;
}

}  // namespace kerf
