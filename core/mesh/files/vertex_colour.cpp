#include "core/mesh/files/vertex_colour.h"

#include <algorithm>
#include <cmath>

namespace kerf {

uint16_t colour_part(double fraction) {
  if (!(fraction > 0)) return 0;
  return static_cast<uint16_t>(std::lround(std::min(fraction, 1.0) * VertexColour::kFull));
}

double linear_light(uint16_t part) {
  const double s = fraction_of(part);
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

uint16_t part_of_linear(double light) {
  if (!(light > 0.0031308)) return colour_part(12.92 * light);
  return colour_part(1.055 * std::pow(std::min(light, 1.0), 1 / 2.4) - 0.055);
}

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

}  // namespace kerf
