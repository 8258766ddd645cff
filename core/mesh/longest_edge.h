#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/one_to_four.h"
#include "core/mesh/replacement.h"

namespace kerf {

// Refinement by bisecting longest edges along their propagation path (M. C. Rivara: New longest-edge
// algorithms for the refinement and/or improvement of unstructured triangulations, 1997).
//
// Bisects f at the midpoint of its longest edge. Where a face on that edge has a longer one, that face is
// bisected first, and so on, so that every bisection splits a whole ring at the longest edge of all its
// faces: the mesh is conforming after each, and no descendant has an angle under half of the smallest of its
// base face. Edges are ordered by length and then by the positions of their ends, so equal lengths cannot go
// round in a circle and all sheets of a ring see the same order.
//
// Green pairs in the way become faces like others. Appends what became of every face that was split. False
// where an edge on the path has no midpoint of its own, because coordinates have an end: f is then as it was.
// The cost is that of the path, which ends soon in practice.
bool bisect_longest_edge(Mesh& mesh, OneToFour& greens, FaceId f, std::vector<Replacement>& out);

}  // namespace kerf
