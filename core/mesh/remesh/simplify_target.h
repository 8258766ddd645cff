#pragma once

#include <cstddef>
#include <limits>

namespace kerf {

// When to stop simplifying: as soon as so many faces are left, or before any vertex, edge midpoint or face
// centroid of the mesh gets farther than kShareForSamples of `error` (m) from the new surface. The surfaces
// are then within about `error` of each other.
struct SimplifyTarget {
  size_t faces = 0;
  double error = std::numeric_limits<double>::infinity();
};

// The part of the error that samples may take, because between them the surface was up to 1.6 times as far
// away, measured both ways.
inline constexpr double kShareForSamples = 0.6;

}  // namespace kerf
