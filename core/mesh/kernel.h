#pragma once

// Private to core/mesh.
#include "core/mesh/half_edges.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The next and the previous half-edge of a ring, both in the direction of half-edge 0 of the edge that holds
// the link. An edge that is alone links to itself.
struct RingLink {
  HalfEdgeId next;
  HalfEdgeId previous;
};

struct Mesh::Kernel {
  HalfEdges half_edges;
  Records<RingLink> rings;  // one an edge, or empty when no edge of the mesh has three faces
  Records<FaceData> faces;  // one a face slot
  uint32_t live_faces = 0;
  uint32_t live_before = 0;  // the command that is remembered
};

struct Mesh::Change::Parts {
  HalfEdges::Change half_edges;
  Records<RingLink>::Change rings;
  Records<FaceData>::Change faces;
  uint32_t live_faces;
};

}  // namespace kerf
