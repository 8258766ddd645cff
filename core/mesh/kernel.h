#pragma once

#include "core/mesh/half_edges.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The next and the previous half-edge of an edge's ring, both in the direction of its half-edge 0. An edge in
// no ring links to itself.
struct RingLink {
  HalfEdgeId next;
  HalfEdgeId previous;
};

struct Mesh::Kernel {
  HalfEdges half_edges;
  Records<RingLink> rings;  // one per edge, or empty if the mesh has no ring
  Records<FaceData> faces;  // one per face slot
  FaceColumns columns;
  VertexColours colours;
  uint32_t live_faces = 0;

  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.half_edges, self.rings, self.faces, self.columns, self.colours, self.live_faces);
  }
};

struct Mesh::Change::Parts : ChangeOfParts<Mesh::Kernel> {};

}  // namespace kerf
