#include "core/mesh/triangle_batch.h"

#include <cassert>

#include "core/base/assert.h"
#include "core/mesh/kernel.h"

namespace kerf {

void TriangleBatch::read_corners(const Mesh& mesh) {
  const HalfEdges& m = mesh.kernel().half_edges;
  std::array<HalfEdgeId, kFaces> side;
  for (uint32_t i = 0; i < count_; ++i) {
    assert(mesh.is_live(face_[i]));
    m.prefetch_first(face_[i]);
  }
  for (uint32_t i = 0; i < count_; ++i) {
    side[i] = m.first(face_[i]);
    m.prefetch_links(side[i]);
  }
  for (uint32_t i = 0; i < count_; ++i) {
    const HalfEdgeId h = side[i];
    corners_[i][0] = m.from(h);
    corners_[i][1] = m.to(h);
    side[i] = m.next(h);
    m.prefetch_links(side[i]);
  }
  for (uint32_t i = 0; i < count_; ++i) corners_[i][2] = m.to(side[i]);
}

void TriangleBatch::read(const Mesh& mesh) {
  read_corners(mesh);
  const HalfEdges& m = mesh.kernel().half_edges;
  for (uint32_t i = 0; i < count_; ++i) {
    for (const VertexId v : corners_[i]) m.prefetch_position(v);
  }
  for (uint32_t i = 0; i < count_; ++i) {
    for (int k = 0; k < 3; ++k) triangle_[i][k] = m.position(corners_[i][k]);
  }
}

}  // namespace kerf
