#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/base/float_frame.h"
#include "core/base/ids.h"

namespace kerf {

// Edges of a surface that pieces may become, to be drawn over the surface that they have.
struct DrawnWire {
  struct Edge {
    glm::vec3 from, to;  // in the float frame
  };
  // The edges of what becomes of one piece, which are drawn as the piece is: displaced, turned or hidden.
  struct Part {
    PieceId piece;
    FloatFrame frame;  // of the coordinates of the world
    std::vector<Edge> edges;
    double mean_edge = 0;  // m
  };
  std::vector<Part> parts;
  double depth = 0;  // m; edges up to so far below a surface are seen
};

}  // namespace kerf
