#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace kerf {

// Reads many faces together. A triangle takes four dependent memory reads, each of which may miss the cache;
// a batch overlaps the reads of many faces. A single face costs more than with Mesh::triangle().
class TriangleBatch {
 public:
  static constexpr uint32_t kFaces = 64;

  // Precondition: the batch is not full.
  void add(FaceId f) {
    assert(room() > 0);
    face_[count_++] = f;
  }
  void clear() { count_ = 0; }
  uint32_t count() const { return count_; }
  uint32_t room() const { return kFaces - count_; }

  // Read the corner vertices of all faces in the batch; read() also reads their positions. Both in the order
  // of Mesh::corners(). Precondition: all faces are live.
  void read_corners(const Mesh& mesh);
  void read(const Mesh& mesh);

  FaceId face(uint32_t i) const { return face_[i]; }
  // Precondition: read_corners() or read() was called.
  const std::array<VertexId, 3>& corners(uint32_t i) const { return corners_[i]; }
  // Precondition: read() was called.
  const Triangle& triangle(uint32_t i) const { return triangle_[i]; }

 private:
  uint32_t count_ = 0;
  std::array<FaceId, kFaces> face_;
  std::array<std::array<VertexId, 3>, kFaces> corners_;
  std::array<Triangle, kFaces> triangle_;
};

// Calls visit(const TriangleBatch&) for the live faces in slots `first` .. `end` - 1, in ascending order.
template <typename Visit>
void for_each_batch(const Mesh& mesh, size_t first, size_t end, Visit visit) {
  TriangleBatch batch;
  for (auto f = static_cast<uint32_t>(first); f < end;) {
    batch.clear();
    for (; f < end && batch.room() > 0; ++f) {
      if (mesh.is_live(FaceId(f))) batch.add(FaceId(f));
    }
    batch.read(mesh);
    visit(batch);
  }
}

// Calls visit(FaceId, const Triangle&) for the live faces of these slots, in ascending order.
template <typename Visit>
void for_each_triangle(const Mesh& mesh, size_t first, size_t end, Visit visit) {
  for_each_batch(mesh, first, end, [&](const TriangleBatch& batch) {
    for (uint32_t i = 0; i < batch.count(); ++i) visit(batch.face(i), batch.triangle(i));
  });
}

// Calls visit(FaceId, const std::array<VertexId, 3>&) for each of `faces`, in order. Precondition: all are
// live.
template <typename Visit>
void for_each_corners(const Mesh& mesh, std::span<const FaceId> faces, Visit visit) {
  TriangleBatch batch;
  while (!faces.empty()) {
    batch.clear();
    const size_t count = std::min<size_t>(faces.size(), TriangleBatch::kFaces);
    for (const FaceId f : faces.first(count)) batch.add(f);
    batch.read_corners(mesh);
    for (uint32_t i = 0; i < batch.count(); ++i) visit(batch.face(i), batch.corners(i));
    faces = faces.subspan(count);
  }
}

// A face reached by a traversal over shared edges, and the side over which it was reached, through which its
// neighbours are found without a lookup of the face. A missing side, or one outdated by an edit of the face,
// costs only time.
struct ReachedFace {
  static constexpr uint32_t kNone = 0xffffffffu;

  FaceId face;
  uint32_t side = kNone;  // private to core/mesh
};

// Visits the faces of a mesh in batches, whose memory accesses overlap. Traversing a large mesh is bound by
// memory latency, so this is several times as fast as visiting face by face.
class FaceWalk {
 public:
  // The mesh must outlive the walk.
  explicit FaceWalk(const Mesh& mesh) : mesh_(mesh) {}

  // Prefetches most of the memory that visiting these faces reads. Precondition: the faces exist and were
  // reached recently, so that the sides themselves need no prefetching.
  void prefetch(std::span<const ReachedFace> faces) const;

  // Visits faces; skips dead ones. The results are valid until the next call.
  void visit(std::span<const ReachedFace> faces);
  // Returns the nearest neighbours of all these faces, in the order of Mesh::append_nearest_neighbours.
  std::span<const ReachedFace> neighbours() const { return neighbours_; }
  // Liveness and area (m^2) of face i of the batch; the area is bit-equal to triangle_area().
  bool is_live(size_t i) const { return corners_[i][0].valid(); }
  double area(size_t i) const { return areas_[i]; }

  // Returns the corners of faces, in their order. Precondition: all are live.
  std::span<const Triangle> triangles(std::span<const FaceId> faces);

 private:
  const Mesh& mesh_;
  std::vector<ReachedFace> neighbours_;
  std::vector<std::array<VertexId, 3>> corners_;  // invalid for a dead face
  std::vector<double> areas_;
  std::vector<Triangle> triangles_;
};

}  // namespace kerf
