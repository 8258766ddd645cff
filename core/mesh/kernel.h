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
  FaceColumns columns;
  uint32_t live_faces = 0;

  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.half_edges, self.rings, self.faces, self.columns, self.live_faces);
  }
};

struct Mesh::Change::Parts : ChangeOfParts<Mesh::Kernel> {};

}  // namespace kerf
