#pragma once

// Private to core/mesh: the only header that pulls OpenMesh in.
#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/Attributes.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <vector>

#include "core/mesh/mesh.h"

namespace kerf {

struct KernelTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<KernelTraits>;
using HalfedgeHandle = OpenMesh::HalfedgeHandle;
using EdgeHandle = OpenMesh::EdgeHandle;

// The next and the previous half-edge of a ring, both in the direction of half-edge 0 of the edge that holds
// the link. An edge that is alone links to itself.
struct RingLink {
  HalfedgeHandle next;
  HalfedgeHandle previous;
};

struct Mesh::Kernel {
  HalfEdges half_edges;
  std::vector<RingLink> rings;  // one an edge, or empty when no edge of the mesh has three faces
  std::vector<FaceData> faces;  // one a face slot
  uint32_t live_faces = 0;
};

inline OpenMesh::FaceHandle handle(FaceId f) { return OpenMesh::FaceHandle(static_cast<int>(f.index)); }
inline OpenMesh::VertexHandle handle(VertexId v) { return OpenMesh::VertexHandle(static_cast<int>(v.index)); }
inline FaceId face_id(OpenMesh::FaceHandle f) { return FaceId(static_cast<uint32_t>(f.idx())); }
inline VertexId vertex_id(OpenMesh::VertexHandle v) { return VertexId(static_cast<uint32_t>(v.idx())); }
inline Vec3 to_vec3(const OpenMesh::Vec3d& p) { return {p[0], p[1], p[2]}; }
inline OpenMesh::Vec3d to_point(const Vec3& p) { return {p.x, p.y, p.z}; }

}  // namespace kerf
