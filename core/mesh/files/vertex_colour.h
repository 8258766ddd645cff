#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

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

// The colours of vertices as numbers of a file that does not say what a full part is: 1, or 255. Numbers are
// bytes if some exceed 1 and all are whole, or if some are larger than programs write for light brighter than
// white; this is decided for the colours of all vertices, and for all opacities. Whole numbers up to 1 are
// bytes, too, beside opacities that are.
class ColourNumbers {
 public:
  using Parts = std::array<double, 4>;  // red, green, blue, opacity
  // A full part, whatever number that is.
  static constexpr double kFull = std::numeric_limits<double>::infinity();

  // Sets the colour of a vertex. Vertices that are left out are opaque white. Precondition: `vertex` is
  // larger than that of the last call.
  void set(size_t vertex, const Parts& parts);

  // The colours of all vertices, or none if none is set. Adds a warning that says what was assumed if there
  // are numbers greater than 1. Linear time.
  std::vector<VertexColour> take(size_t vertices, std::vector<std::string>& warnings) const;

 private:
  // Some of the finite numbers.
  struct Range {
    double largest = 0;
    bool whole = true;

    void add(double number);
    bool are_bytes() const;
  };

  std::vector<Parts> numbers_;  // by vertex, up to the last one that has a colour
  Range colours_, opacities_;
};

}  // namespace kerf
