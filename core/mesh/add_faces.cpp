#include <map>
#include <optional>

#include "core/base/assert.h"
#include "core/mesh/kernel.h"
#include "core/mesh/mesh.h"
#include "core/mesh/rings.h"

namespace kerf {

namespace {

using FaceCorners = std::array<VertexId, 3>;

HalfEdgeId open_half_edge(const HalfEdges& m, VertexId from, VertexId to) {
  HalfEdgeId found;
  m.for_each_outgoing(from, [&](HalfEdgeId h) {
    if (!found.valid() && m.to(h) == to && !m.face(h).valid()) found = h;
  });
  return found;
}

// The half-edges at some vertices, before faces are added there and after it.
class FansAtVertices {
 public:
  explicit FansAtVertices(Mesh::Kernel& kernel) : kernel_(kernel), m_(kernel.half_edges) {}

  // Notes the half-edges that start at a vertex. To be called before any face is added.
  void note(VertexId v) {
    if (outgoing_.contains(v)) return;
    std::vector<HalfEdgeId>& own = outgoing_[v];
    m_.for_each_outgoing(v, [&](HalfEdgeId h) { own.push_back(h); });
  }
  void add(VertexId v, HalfEdgeId h) { outgoing_.at(v).push_back(h); }

  // Links the half-edges around every vertex anew. A vertex where several fans touch gives way to one vertex
  // for each of them.
  void link() {
    for (const auto& [v, outgoing] : outgoing_) {
      for (const HalfEdgeId h : outgoing) {
        if (!m_.face(opposite(h)).valid()) link_boundary(opposite(h));
      }
    }
    for (const auto& [v, outgoing] : outgoing_) part_fans(v, outgoing);
  }

 private:
  // A boundary half-edge is followed by the one that bounds the same fan on its other side.
  void link_boundary(HalfEdgeId h) {
    HalfEdgeId after = opposite(h);
    while (m_.face(after).valid()) after = opposite(m_.previous(after));
    m_.link(h, after);
  }

  void part_fans(VertexId v, const std::vector<HalfEdgeId>& outgoing) {
    std::map<HalfEdgeId, bool> seen;
    for (const HalfEdgeId h : outgoing) seen[h] = false;
    bool first = true;
    for (const HalfEdgeId start : outgoing) {
      if (seen[start]) continue;
      const VertexId own = first ? v : copy_of(v);
      first = false;
      HalfEdgeId h = start;
      do {
        seen[h] = true;
        m_.set_to(opposite(h), own);
        h = m_.next(opposite(h));
      } while (h != start);
      m_.set_outgoing(own, start);
    }
  }

  VertexId copy_of(VertexId v) {
    const VertexId copy = m_.add_vertex(Vec3(m_.position(v)));
    if (!kernel_.colours.blank()) kernel_.colours.set(copy, kernel_.colours.get(v));
    return copy;
  }

  Mesh::Kernel& kernel_;
  HalfEdges& m_;
  std::map<VertexId, std::vector<HalfEdgeId>> outgoing_;
};

// The sides of new faces: open half-edges that are there, and one new edge for two opposite sides.
class SidesOfNewFaces {
 public:
  SidesOfNewFaces(HalfEdges& m, FansAtVertices& fans) : m_(m), fans_(fans) {}

  void find(VertexId from, VertexId to) {
    fans_.note(from);
    const HalfEdgeId open = open_half_edge(m_, from, to);
    if (open.valid()) sides_[{from, to}] = open;
  }

  HalfEdgeId side(VertexId from, VertexId to) {
    const auto known = sides_.find({from, to});
    if (known != sides_.end()) {
      KERF_ASSERT(!m_.face(known->second).valid());
      return known->second;
    }
    const HalfEdgeId h = m_.add_edge(from, to);
    fans_.add(from, h);
    fans_.add(to, opposite(h));
    sides_[{from, to}] = h;
    sides_[{to, from}] = opposite(h);
    return h;
  }

 private:
  HalfEdges& m_;
  FansAtVertices& fans_;
  std::map<std::pair<VertexId, VertexId>, HalfEdgeId> sides_;
};

}  // namespace

VertexId Mesh::add_vertex(const Vec3& position) { return kernel_->half_edges.add_vertex(position); }

std::vector<FaceId> Mesh::add_faces(std::span<const FaceCorners> corners, std::span<const FaceData> data) {
  KERF_ASSERT(corners.size() == data.size());
  Kernel& k = *kernel_;
  HalfEdges& m = k.half_edges;
  FansAtVertices fans(k);
  SidesOfNewFaces sides(m, fans);
  for (const FaceCorners& c : corners) {
    for (size_t i = 0; i < 3; ++i) sides.find(c[i], c[(i + 1) % 3]);
  }
  std::vector<FaceId> added;
  for (size_t i = 0; i < corners.size(); ++i) {
    const auto [a, b, c] = corners[i];
    const HalfEdgeId ab = sides.side(a, b), bc = sides.side(b, c), ca = sides.side(c, a);
    const FaceId f = m.add_face(ab);
    m.close(f, ab, bc, ca);
    k.faces.push_back(data[i]);
    k.faces.edit(f.index).base = f;
    added.push_back(f);
  }
  k.live_faces += static_cast<uint32_t>(added.size());
  if (!k.rings.empty()) add_lone_rings(k);
  fans.link();
  return added;
}

}  // namespace kerf
