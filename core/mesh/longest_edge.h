#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/one_to_four.h"
#include "core/mesh/replacement.h"

namespace kerf {

// Refinement by bisecting longest edges along their propagation path (M. C. Rivara: New longest-edge
// algorithms for the refinement and/or improvement of unstructured triangulations, 1997).
//
// Bisects f at the midpoint of its longest edge. If a face on that edge has a longer edge, that face is
// bisected first, and so on, so that every bisection splits a whole ring at the longest edge of all its
// faces. The mesh is conforming after each bisection, and no descendant has an angle smaller than half the
// smallest angle of its base face. Edges are ordered by length and then by the positions of their ends, so
// that equal lengths cause no cycle and all sheets of a ring see the same order.
//
// Green pairs on the path become ordinary faces. Appends a replacement for every face that was split. Returns
// false if an edge on the path is so short that its midpoint rounds to one of its ends; f itself is then
// unchanged. Precondition: f is live. The cost is proportional to the length of the path, which is short in
// practice.
bool bisect_longest_edge(Mesh& mesh, OneToFour& greens, FaceId f, std::vector<Replacement>& out);

}  // namespace kerf
