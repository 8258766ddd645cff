#include "core/mesh/files/vertex_colour.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"

namespace kerf {

uint16_t colour_part(double fraction) {
  if (!(fraction > 0)) return 0;
  return static_cast<uint16_t>(std::lround(std::min(fraction, 1.0) * VertexColour::kFull));
}

namespace {

// Precondition: x is positive.
double power(double x, double exponent) { return det::exp(exponent * det::log(x)); }

}  // namespace

double srgb_to_linear(double s) {
  if (!(s > 0)) return 0;
  if (s >= 1) return 1;
  return s <= 0.04045 ? s / 12.92 : power((s + 0.055) / 1.055, 2.4);
}

double linear_to_srgb(double light) {
  if (!(light > 0)) return 0;
  if (light >= 1) return 1;
  return light <= 0.0031308 ? 12.92 * light : 1.055 * power(light, 1 / 2.4) - 0.055;
}

uint16_t part_of_linear(double light) { return colour_part(linear_to_srgb(light)); }

VertexColour mix(const VertexColour& a, const VertexColour& b, double fraction) {
  return mix({a, b, b}, {1 - fraction, fraction, 0});
}

VertexColour mix(const std::array<VertexColour, 3>& colours, const std::array<double, 3>& weights) {
  VertexColour mixed;
  for (size_t k = 0; k < mixed.part.size(); ++k) {
    double sum = 0;
    for (size_t i = 0; i < 3; ++i) sum += weights[i] * colours[i].part[k];
    mixed.part[k] = static_cast<uint16_t>(std::lround(std::clamp<double>(sum, 0, VertexColour::kFull)));
  }
  return mixed;
}

namespace {

constexpr double kMaxByte = 255;
constexpr double kMaxLight = 16;  // maximum fraction; light brighter than white is far below it

}  // namespace

void ColourNumbers::Range::add(double number) {
  if (!std::isfinite(number)) return;
  largest = std::max(largest, number);
  whole = whole && number == std::floor(number);
}

bool ColourNumbers::Range::are_bytes() const { return largest > kMaxLight || (largest > 1 && whole); }

void ColourNumbers::set(size_t vertex, const Parts& parts) {
  KERF_ASSERT(vertex >= numbers_.size());
  numbers_.resize(vertex, {kFull, kFull, kFull, kFull});
  numbers_.push_back(parts);
  for (size_t k = 0; k < VertexColour::kOpacity; ++k) colours_.add(parts[k]);
  opacities_.add(parts[VertexColour::kOpacity]);
}

std::vector<VertexColour> ColourNumbers::take(size_t vertices, std::vector<std::string>& warnings) const {
  if (numbers_.empty()) return {};
  const bool opacity_bytes = opacities_.are_bytes(),
             bytes = colours_.are_bytes() || (opacity_bytes && colours_.whole);
  if (bytes || opacity_bytes) {
    warnings.push_back("Vertex colours were read as numbers from 0 to 255, because some exceed 1.");
  } else if (std::max(colours_.largest, opacities_.largest) > 1) {
    warnings.push_back("Vertex colours were read as numbers from 0 to 1; greater ones count as 1.");
  }
  Parts full;
  full.fill(bytes ? kMaxByte : 1);
  full[VertexColour::kOpacity] = opacity_bytes ? kMaxByte : 1;
  std::vector<VertexColour> colours(vertices);
  for (size_t v = 0; v < std::min(vertices, numbers_.size()); ++v) {
    for (size_t k = 0; k < full.size(); ++k) colours[v].part[k] = colour_part(numbers_[v][k] / full[k]);
  }
  return colours;
}

}  // namespace kerf
