#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/mesh/files/vertex_colour.h"

namespace kerf {

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
