#pragma once

// Private to core/mesh.
#include "core/mesh/kernel.h"

namespace kerf {

// The next and the previous half-edge of h's ring, in h's direction; h itself where its edge is alone. A mesh
// without any ring keeps no links.
HalfEdgeId next_in_ring(const Mesh::Kernel& k, HalfEdgeId h);
HalfEdgeId previous_in_ring(const Mesh::Kernel& k, HalfEdgeId h);

// Gives every edge that has no link yet a ring of its own.
void add_lone_rings(Mesh::Kernel& k);

// Links half-edges of one direction, of bit-equal ends, into one ring.
void link_ring(Mesh::Kernel& k, const std::vector<HalfEdgeId>& members);

// Puts h, whose edge is alone, behind `member` of a ring of the same direction and ends.
void join_ring(Mesh::Kernel& k, HalfEdgeId h, HalfEdgeId member);

// Takes an edge out of its ring.
void leave_ring(Mesh::Kernel& k, EdgeId e);

}  // namespace kerf
