#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace kerf {

// A face that a traversal over shared edges has reached, with the side over which it came: what lies around
// the face is then found without looking the face up first. A side that is missing, or outdated because the
// face was edited meanwhile, costs time only.
struct ReachedFace {
  static constexpr uint32_t kNone = 0xffffffffu;

  FaceId face;
  uint32_t side = kNone;  // private to core/mesh
};

// Visits the faces of a mesh in batches, such that the memory accesses of a batch overlap. A traversal of a
// large mesh waits for memory most of the time, so this is several times as fast as going face by face.
class FaceWalk {
 public:
  // Precondition: the mesh outlives the walk.
  explicit FaceWalk(const Mesh& mesh) : mesh_(mesh) {}

  // Prefetches most of what visiting these faces reads. Precondition: the faces exist, and they were reached
  // a moment ago, so that the sides themselves need no prefetching.
  void prefetch(std::span<const ReachedFace> faces) const;

  // Visits faces; a dead one is skipped. The results are valid until the next call.
  void visit(std::span<const ReachedFace> faces);
  // The nearest neighbours of all these faces, in the order of Mesh::append_nearest_neighbours.
  std::span<const ReachedFace> neighbours() const { return neighbours_; }
  // Whether the face with this index in the batch is live, and its area (m^2) if it is, to the bit that of
  // triangle_area().
  bool is_live(size_t i) const { return corners_[i][0].valid(); }
  double area(size_t i) const { return areas_[i]; }

  // The corners of faces, in their order. Precondition: all are live.
  std::span<const Triangle> triangles(std::span<const FaceId> faces);

 private:
  const Mesh& mesh_;
  std::vector<ReachedFace> neighbours_;
  std::vector<std::array<VertexId, 3>> corners_;  // invalid for a dead face
  std::vector<double> areas_;
  std::vector<Triangle> triangles_;
};

}  // namespace kerf
