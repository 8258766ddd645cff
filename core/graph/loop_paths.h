#pragma once

#include <vector>

#include "core/base/vec3.h"
#include "core/world/cut_face.h"
#include "core/world/world.h"

namespace kerf {

// A loop of removed faces that the removal of one of them closed (see CutLoops), as a line on the surface
// along their edges.
struct LoopPath {
  BodyId body;               // from which the faces were removed
  size_t removal = 0;        // the one that closed it: of all removals in their order, counted from 1
  std::vector<Vec3> points;  // m, in the world
  bool runs_around = true;   // else it goes from border to border, and the border closes it
};

// The loops that a stroke closed, in the order of its removals, each by a shortest way, in edges, through the
// faces that were removed before. Faces are matched by the positions of their corners, and an edge that was
// split by those of its midpoints. A loop whose way cannot be found so is left out, as where it runs over a
// border that the whole stroke meets in single vertices alone. Bodies that no longer exist are left out. O(n
// log n) in the removed faces, plus for each loop linear time in the faces that were removed before; the
// search ends after `most_visits` vertices.
std::vector<LoopPath> loop_paths(const World& world, const CutFaces& removed,
                                 size_t most_visits = 20'000'000);

}  // namespace kerf
