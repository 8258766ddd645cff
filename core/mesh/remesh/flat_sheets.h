#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/float_frame.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The live faces of a mesh in flat arrays, with one vertex for each fan of faces on a sheet (see Mesh), so
// that no vertex joins two sheets. Faces and vertices are numbered in the order of their slots in the mesh.
//
// An edge is a feature if it is on a boundary or in a ring, or if the materials of its faces differ. Locked
// are the ends of features, vertices at whose position there is another vertex, and those of faces that are
// to be kept.
struct FlatSheets {
  FloatFrame frame;                              // in which OpenMesh and the quadrics compute
  std::vector<VertexId> vertices;                // by vertex; one of the mesh with several fans comes again
  std::vector<FaceId> faces;                     // by face, ascending
  std::vector<std::array<uint32_t, 3>> corners;  // by face: vertices, counter-clockwise
  std::vector<bool> feature;  // side 3 f + i of face f, which runs from corner i to the next one
  std::vector<bool> locked;   // by vertex
  std::vector<bool> shared;   // by vertex: another vertex has the same position

  // The position of a vertex in the frame of the sheets. Precondition: they were made of `mesh`.
  Vec3 point(const Mesh& mesh, uint32_t v) const { return frame.scaled(mesh.position(vertices[v])); }
};

// Copies the live faces of a mesh. Fails with cancelled() when stopped; `progress` may be null. Precondition:
// the faces in `kept` are live. O(n log n).
Result<FlatSheets> to_flat_sheets(const Mesh& mesh, std::span<const FaceId> kept, const Progress* progress);

}  // namespace kerf
