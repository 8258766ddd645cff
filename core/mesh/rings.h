#pragma once

#include "core/mesh/kernel.h"

namespace kerf {

// A ring links the coincident edges of a mesh (see Mesh); a mesh without rings stores no links.

// The next and the previous half-edge in the ring of h, in the direction of h; h itself if its edge is in no
// ring.
HalfEdgeId next_in_ring(const Mesh::Kernel& k, HalfEdgeId h);
HalfEdgeId previous_in_ring(const Mesh::Kernel& k, HalfEdgeId h);

// Gives every edge without a link a ring of its own.
void add_lone_rings(Mesh::Kernel& k);

// Links half-edges into one ring. Precondition: they have the same direction and bit-equal ends.
void link_ring(Mesh::Kernel& k, const std::vector<HalfEdgeId>& members);

// Inserts h after `member` into its ring. Preconditions: the edge of h is in no ring, and both half-edges
// have the same direction and bit-equal ends.
void join_ring(Mesh::Kernel& k, HalfEdgeId h, HalfEdgeId member);

// Removes an edge from its ring. An edge in no ring is left unchanged.
void leave_ring(Mesh::Kernel& k, EdgeId e);

}  // namespace kerf
