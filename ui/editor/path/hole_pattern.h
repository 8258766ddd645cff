#pragma once

#include <vector>

#include "core/document/files/path_file.h"

namespace kerf {

// Holes in a grid or on a circle, all drilled in one direction.
struct HolePattern {
  enum class Kind { kGrid, kCircle };
  Kind kind = Kind::kGrid;
  int rows = 3, columns = 4;   // of a grid, 1 .. kMostInALine
  double spacing = 0.1;        // m, between the middles of neighbours in a grid
  int count = 8;               // on a circle, 1 .. kMostInALine
  double circle_radius = 0.2;  // m, of the circle on which the middles lie
  double hole_radius = 0.03;   // m

  static constexpr int kMostInALine = 100;
};

// The strokes that drill the holes, one for each: the beam, of this radius (m), goes once round along the
// inside of the hole and ends where it began. A hole that is no wider than the beam is one key of a beam as
// wide as the hole. `beam` is in the middle of the pattern. The rows of a grid lie along the axis of the
// world that is most nearly across the beam, X before Z before Y. The times are those of 1 m/s. Precondition:
// all numbers are positive, and the direction is one of beam_direction().
std::vector<StrokePath> hole_strokes(const HolePattern& pattern, const Pose& beam, double radius);

}  // namespace kerf
