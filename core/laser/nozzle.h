#pragma once

#include <optional>

#include "core/mesh/mesh.h"
#include "core/tree/aabb_tree.h"

namespace kerf {

// The nozzle around a beam: a cone that widens from its tip, at the origin of the beam, against its
// direction.
struct Nozzle {
  double radius = 0;  // of the tip, m, > 0
  double slope = 0;   // growth of the radius per metre, >= 0
  double length = 0;  // m, > 0

  static constexpr int kSides = 32;
};

// Returns true if the nozzle, as a pyramid of kSides sides around the cone, meets a face. `beam` is in the
// frame of the mesh. O(log n + faces near the nozzle).
bool collides(const Mesh& mesh, const AabbTree& tree, const Pose& beam, const Nozzle& nozzle);

}  // namespace kerf
