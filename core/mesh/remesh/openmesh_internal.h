#pragma once

#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"
#include "core/mesh/remesh/flat_sheets_internal.h"
#include "core/mesh/remesh/remeshed.h"

// Only core/mesh/remesh includes OpenMesh's headers. As system headers they cause no warnings.
#ifndef _USE_MATH_DEFINES
#define _USE_MATH_DEFINES  // OpenMesh uses M_PI
#endif
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace kerf {

struct OpenMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};

using OpenMeshKernel = OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits>;

// The flat sheets of a mesh as a mesh of OpenMesh, which is manifold, with their features, locked and shared
// vertices. Positions are scaled to about [-1, 1] around the middle of the mesh, because OpenMesh has
// absolute tolerances.
struct Sheets {
  using Kernel = OpenMeshKernel;

  Kernel mesh;
  FloatFrame frame;
  std::vector<VertexId> vertices;  // by vertex handle; repeats a vertex with several fans
  std::vector<FaceId> faces;       // by face handle, ascending
  std::vector<bool> shared;        // by vertex handle: another vertex has the same position
  size_t detached = 0;             // faces that OpenMesh could not connect

  Kernel::VertexHandle vertex(size_t i) const { return Kernel::VertexHandle(static_cast<int>(i)); }
  Kernel::FaceHandle face(size_t i) const { return Kernel::FaceHandle(static_cast<int>(i)); }
};

// Copies the live faces of a mesh via to_flat_sheets. OpenMesh allows at most one edge between two vertices,
// with two faces; a sheet that touches itself along a ring may need more, and a face without a free edge gets
// locked vertices of its own. Fails with cancelled() when stopped; `progress` may be null. Precondition: the
// faces in `limits.kept` are live. O(n log n).
Result<Sheets> to_sheets(const Mesh& mesh, const RemeshLimits& limits, const Progress* progress);

// Copies a mesh of OpenMesh back: the faces that are not deleted, in the order of `origin`, which maps each
// face handle to the face of `mesh` from which it derives. Vertices that did not move since to_sheets get
// their position in `mesh`. Drops triangles with two corners at the same position.
Remeshed from_sheets(const Sheets& sheets, std::span<const FaceId> origin, const Mesh& mesh);

}  // namespace kerf
