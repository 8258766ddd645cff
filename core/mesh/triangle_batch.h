#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "core/mesh/mesh.h"

namespace kerf {

// Faces that are read together. A triangle lies behind four reads that wait for one another, each of which
// may miss the cache; in a batch those of many faces are under way at once. For callers that read many faces,
// in any order; a single face costs more than by Mesh::triangle().
class TriangleBatch {
 public:
  static constexpr uint32_t kFaces = 64;

  // Precondition: the batch has room.
  void add(FaceId f) { face_[count_++] = f; }
  void clear() { count_ = 0; }
  uint32_t count() const { return count_; }
  uint32_t room() const { return kFaces - count_; }

  // Reads the corners of all faces in the batch, or those and their positions; they come in the order of
  // Mesh::corners(). Precondition: all faces are live.
  void read_corners(const Mesh& mesh);
  void read(const Mesh& mesh);

  FaceId face(uint32_t i) const { return face_[i]; }
  // After read_corners() or read().
  const std::array<VertexId, 3>& corners(uint32_t i) const { return corners_[i]; }
  // After read().
  const Triangle& triangle(uint32_t i) const { return triangle_[i]; }

 private:
  uint32_t count_ = 0;
  std::array<FaceId, kFaces> face_;
  std::array<std::array<VertexId, 3>, kFaces> corners_;
  std::array<Triangle, kFaces> triangle_;
};

// Calls visit(const TriangleBatch&) for the live faces of the slots from `first` to `end`, in ascending
// order.
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

// Calls visit(FaceId, const std::array<VertexId, 3>&) for some live faces, in their order.
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

}  // namespace kerf
