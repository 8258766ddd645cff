#include "core/mesh/face_batches.h"

#include <cassert>

#include "core/mesh/half_edges_internal.h"

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

namespace {

// The sides of a face, in order from its first one.
using Sides = std::array<HalfEdgeId, 3>;

// Starts from a known side if there is one, because the first side must be read from memory.
Sides sides_of(const HalfEdges& m, const ReachedFace& reached, HalfEdgeId first) {
  const HalfEdgeId hint(reached.side);
  const bool known = hint.valid() && m.face(hint) == reached.face;
  const HalfEdgeId a = known ? hint : first, b = m.next(a), c = m.previous(a);
  if (first == a) return {a, b, c};
  return first == b ? Sides{b, c, a} : Sides{c, a, b};
}

// A side ends at the start of the next one.
std::array<VertexId, 3> corners_of(const HalfEdges& m, const Sides& sides) {
  return {m.to(sides[2]), m.to(sides[0]), m.to(sides[1])};
}

// Appends the faces across a side; of a ring only the two next to it.
void append_beyond(const Mesh::Kernel& k, HalfEdgeId side, std::vector<ReachedFace>& out) {
  const HalfEdges& m = k.half_edges;
  const auto append = [&](HalfEdgeId h) { out.push_back({m.face(h), h.index}); };
  const auto append_one = [&](HalfEdgeId member) {
    append(m.face(member).valid() ? member : opposite(member));
  };
  const HalfEdgeId across = opposite(side);
  if (m.face(across).valid()) append(across);
  if (k.rings.empty()) return;
  const HalfEdgeId next = next_in_ring(k, side), previous = previous_in_ring(k, side);
  if (next != side) append_one(next);
  if (previous != next) append_one(previous);
}

}  // namespace

void FaceWalk::prefetch(std::span<const ReachedFace> faces) const {
  const HalfEdges& m = mesh_.kernel().half_edges;
  for (const ReachedFace& f : faces) m.prefetch_around(f.face, HalfEdgeId(f.side));
}

void FaceWalk::visit(std::span<const ReachedFace> faces) {
  const Mesh::Kernel& k = mesh_.kernel();
  const HalfEdges& m = k.half_edges;
  const Positions positions = mesh_.positions();
  neighbours_.clear();
  corners_.assign(faces.size(), {});
  for (size_t i = 0; i < faces.size(); ++i) {
    const HalfEdgeId first = m.first(faces[i].face);
    if (!first.valid()) continue;
    const Sides sides = sides_of(m, faces[i], first);
    corners_[i] = corners_of(m, sides);
    for (const VertexId v : corners_[i]) __builtin_prefetch(&positions[v]);
    for (const HalfEdgeId side : sides) append_beyond(k, side, neighbours_);
  }
  areas_.resize(faces.size());
  for (size_t i = 0; i < faces.size(); ++i) {
    const auto& c = corners_[i];
    areas_[i] = c[0].valid() ? triangle_area({positions[c[0]], positions[c[1]], positions[c[2]]}) : 0;
  }
}

std::span<const Triangle> FaceWalk::triangles(std::span<const FaceId> faces) {
  const HalfEdges& m = mesh_.kernel().half_edges;
  const Positions positions = mesh_.positions();
  for (int turn = 0; turn < HalfEdges::kTurns; ++turn) {
    for (const FaceId f : faces) m.prefetch(f, turn);
  }
  corners_.resize(faces.size());
  for (size_t i = 0; i < faces.size(); ++i) {
    assert(mesh_.is_live(faces[i]));
    const HalfEdgeId first = m.first(faces[i]);
    corners_[i] = corners_of(m, {first, m.next(first), m.previous(first)});
    __builtin_prefetch(&positions[corners_[i][2]]);
  }
  triangles_.clear();
  for (const auto& c : corners_) triangles_.push_back({positions[c[0]], positions[c[1]], positions[c[2]]});
  return triangles_;
}

}  // namespace kerf
