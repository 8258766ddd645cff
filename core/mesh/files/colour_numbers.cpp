#include "core/mesh/files/colour_numbers.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kLargestByte = 255;
constexpr double kLargestLight = 16;  // of fractions; light brighter than white stays far below it

}  // namespace

void ColourNumbers::Range::add(double number) {
  if (!std::isfinite(number)) return;
  largest = std::max(largest, number);
  whole = whole && number == std::floor(number);
}

bool ColourNumbers::Range::are_bytes() const { return largest > kLargestLight || (largest > 1 && whole); }

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
    warnings.push_back(
        "Colours of vertices were taken for numbers from 0 to 255, because some are greater than 1.");
  } else if (std::max(colours_.largest, opacities_.largest) > 1) {
    warnings.push_back(
        "Colours of vertices were taken for numbers from 0 to 1; those that are greater count as 1.");
  }
  Parts full;
  full.fill(bytes ? kLargestByte : 1);
  full[VertexColour::kOpacity] = opacity_bytes ? kLargestByte : 1;
  std::vector<VertexColour> colours(vertices);
  for (size_t v = 0; v < std::min(vertices, numbers_.size()); ++v) {
    for (size_t k = 0; k < full.size(); ++k) colours[v].part[k] = colour_part(numbers_[v][k] / full[k]);
  }
  return colours;
}

}  // namespace kerf
