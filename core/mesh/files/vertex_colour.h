#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace kerf {

// A vertex colour with opacity: red, green, blue in sRGB and opacity, each from 0 to kFull. Numbers of eight
// bits, and fractions derived from them, are stored exactly.
struct VertexColour {
  static constexpr uint16_t kFull = 0xffff;
  static constexpr size_t kOpacity = 3;

  std::array<uint16_t, 4> part{kFull, kFull, kFull, kFull};

  friend bool operator==(const VertexColour&, const VertexColour&) = default;
};

// Converts a fraction to a component; values outside 0 .. 1 are clamped, and NaN becomes 0.
uint16_t colour_part(double fraction);
inline double fraction_of(uint16_t part) { return static_cast<double>(part) / VertexColour::kFull; }

// Convert between a component of an sRGB colour and linear light, 0 .. 1 (IEC 61966-2-1), bit-identical on
// every machine. Values outside that range are clamped, and NaN becomes 0.
double srgb_to_linear(double s);
double linear_to_srgb(double light);

inline double linear_light(uint16_t part) { return srgb_to_linear(fraction_of(part)); }
uint16_t part_of_linear(double light);

// Returns the colour between two at a fraction 0 .. 1 of the way.
VertexColour mix(const VertexColour& a, const VertexColour& b, double fraction);
// Returns the sum of three colours with weights that add up to 1.
VertexColour mix(const std::array<VertexColour, 3>& colours, const std::array<double, 3>& weights);

// Vertex colours as numbers of a file that does not specify their maximum: 1, or 255. Numbers are bytes if
// some exceed 1 and all are whole, or if some are larger than programs write for light brighter than white.
// This is determined once for the colours of all vertices, and once for all opacities. Whole numbers up to 1
// are bytes, too, if the opacities are.
class ColourNumbers {
 public:
  using Parts = std::array<double, 4>;  // red, green, blue, opacity
  // The maximum of a component, whatever number that is.
  static constexpr double kFull = std::numeric_limits<double>::infinity();

  // Sets the colour of a vertex. Others are opaque white. Precondition: `vertex` increases with each call.
  void set(size_t vertex, const Parts& parts);

  // Returns the colours of all vertices, or none if none is set. If there are numbers greater than 1, adds a
  // warning that states the assumption. Linear time.
  std::vector<VertexColour> take(size_t vertices, std::vector<std::string>& warnings) const;

 private:
  // The range of some of the finite numbers.
  struct Range {
    double largest = 0;
    bool whole = true;

    void add(double number);
    bool are_bytes() const;
  };

  std::vector<Parts> numbers_;  // by vertex, up to the last coloured one
  Range colours_, opacities_;
};

}  // namespace kerf
