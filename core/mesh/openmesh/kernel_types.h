#pragma once

// Private to core/mesh/openmesh, which alone includes OpenMesh's headers. They are system headers, so that
// Kerf's warnings do not apply to them.
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

}  // namespace kerf
