#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"
#include "core/mesh/remesh/remeshed.h"

namespace kerf {

// The live faces of a mesh in flat arrays, with one vertex for each fan of faces on a sheet (see Mesh), so
// that no vertex joins two sheets. Faces and vertices are numbered in the order of their slots in the mesh.
//
// An edge is a feature if it is on a boundary or in a ring, or if the materials of its faces differ, or on a
// seam. Locked are the ends of features, vertices at a shared position, and the vertices of kept faces.
struct FlatSheets {
  FloatFrame frame;                              // for OpenMesh and the quadrics
  std::vector<VertexId> vertices;                // by vertex; repeats a vertex of the mesh with several fans
  std::vector<FaceId> faces;                     // by face, ascending
  std::vector<std::array<uint32_t, 3>> corners;  // by face: vertices, counter-clockwise
  std::vector<bool> feature;                     // side 3 f + i of face f, from corner i to the next one
  std::vector<bool> locked;                      // by vertex
  std::vector<bool> shared;                      // by vertex: another vertex has the same position
  std::vector<std::vector<FaceUvs>> uv_sets;     // by set and face

  // Returns the position of a vertex in the frame of the sheets. Precondition: they were made of `mesh`.
  Vec3 point(const Mesh& mesh, uint32_t v) const { return frame.scaled(mesh.position(vertices[v])); }
};

// Copies the live faces of a mesh. Fails with cancelled() when stopped; `progress` may be null. Precondition:
// the faces in `limits.kept` are live. O(n log n).
Result<FlatSheets> to_flat_sheets(const Mesh& mesh, const RemeshLimits& limits, const Progress* progress);

// Triangles over vertices in flat arrays, for removing vertices by half-edge collapses. Corner 3 f + i is
// corner i of face f; the corners at one vertex are a ring of links in no particular order, so that joining
// two rings and removing a corner take constant time.
class FlatSurface {
 public:
  // The side of a face opposite to a vertex; from, to and the vertex are counter-clockwise.
  struct Opposite {
    uint32_t face, from, to;
  };

  FlatSurface(std::vector<Vec3> points, std::vector<std::array<uint32_t, 3>> corners);

  const Vec3& point(uint32_t v) const { return points_[v]; }
  uint32_t vertices() const { return static_cast<uint32_t>(points_.size()); }
  uint32_t faces() const { return static_cast<uint32_t>(corners_.size()); }
  // Precondition: has(f).
  const std::array<uint32_t, 3>& corners(uint32_t f) const { return corners_[f]; }
  bool has(uint32_t f) const { return corners_[f][0] != kNoIndex; }
  bool in_use(uint32_t v) const { return first_[v] != kNoIndex; }
  uint32_t faces_at(uint32_t v) const { return valence_[v]; }

  // Calls see(Opposite) for each face at a vertex.
  template <typename F>
  void for_each_face(uint32_t v, F see) const {
    const uint32_t first = first_[v];
    if (first == kNoIndex) return;
    uint32_t c = first;
    do {
      const uint32_t f = c / 3, i = c - 3 * f;
      see(Opposite{f, corners_[f][i == 2 ? 0 : i + 1], corners_[f][i == 0 ? 2 : i - 1]});
      c = next_[c];
    } while (c != first);
  }

  // Moves all faces at `from` to `to`, but removes the two that have both as corners. Precondition: there are
  // exactly two such faces, and further ones at `from`. Linear in the faces at `from`.
  void collapse(uint32_t from, uint32_t to);

 private:
  void link(uint32_t corner, uint32_t after);
  void unlink(uint32_t corner);

  std::vector<Vec3> points_;
  std::vector<std::array<uint32_t, 3>> corners_;  // by face; kNoIndex if removed
  std::vector<uint32_t> next_, previous_;         // by corner: the next and previous one at its vertex
  std::vector<uint32_t> first_;                   // by vertex: any corner; kNoIndex if there is none
  std::vector<uint32_t> valence_;                 // by vertex: faces
};

}  // namespace kerf
