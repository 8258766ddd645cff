#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kerf {

// A colour with opacity as files give it to vertices: red, green, blue in sRGB and opacity, each from 0 to
// kFull. Numbers of eight bits, and fractions that stem from them, are kept exactly.
struct VertexColour {
  static constexpr uint16_t kFull = 0xffff;
  static constexpr size_t kOpacity = 3;

  std::array<uint16_t, 4> part{kFull, kFull, kFull, kFull};

  friend bool operator==(const VertexColour&, const VertexColour&) = default;
};

// A fraction as a part of a colour; what lies outside 0 .. 1 or is no number is set to the nearest end, or 0.
uint16_t colour_part(double fraction);
inline double fraction_of(uint16_t part) { return static_cast<double>(part) / VertexColour::kFull; }

// The light that a part of an sRGB colour stands for, 0 .. 1, and the part that stands for it (IEC
// 61966-2-1).
double linear_light(uint16_t part);
uint16_t part_of_linear(double light);

// The colour between two at a fraction 0 .. 1 of the way.
VertexColour mix(const VertexColour& a, const VertexColour& b, double fraction);
// The sum of three colours with weights that add up to 1.
VertexColour mix(const std::array<VertexColour, 3>& colours, const std::array<double, 3>& weights);

}  // namespace kerf
