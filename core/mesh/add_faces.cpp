#include <algorithm>
#include <utility>
#include <vector>

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
  FansAtVertices(Mesh::Kernel& kernel, std::span<const FaceCorners> faces)
      : kernel_(kernel), m_(kernel.half_edges) {
    for (const FaceCorners& c : faces) vertices_.insert(vertices_.end(), c.begin(), c.end());
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    outgoing_.resize(vertices_.size());
    for (size_t i = 0; i < vertices_.size(); ++i)
      m_.for_each_outgoing(vertices_[i], [&](HalfEdgeId h) { outgoing_[i].push_back(h); });
  }

  // Notes a half-edge that starts at a vertex of a face.
  void add(VertexId v, HalfEdgeId h) {
    const auto at = std::lower_bound(vertices_.begin(), vertices_.end(), v);
    outgoing_[static_cast<size_t>(at - vertices_.begin())].push_back(h);
  }

  // Links the half-edges around every vertex anew. A vertex where several fans touch gives way to one vertex
  // for each of them.
  void link() {
    for (const std::vector<HalfEdgeId>& outgoing : outgoing_) {
      for (const HalfEdgeId h : outgoing) {
        if (!m_.face(opposite(h)).valid()) link_boundary(opposite(h));
      }
    }
    for (size_t i = 0; i < vertices_.size(); ++i) part_fans(vertices_[i], outgoing_[i]);
  }

 private:
  // A boundary half-edge is followed by the one that bounds the same fan on its other side.
  void link_boundary(HalfEdgeId h) {
    HalfEdgeId after = opposite(h);
    while (m_.face(after).valid()) after = opposite(m_.previous(after));
    m_.link(h, after);
  }

  void part_fans(VertexId v, const std::vector<HalfEdgeId>& outgoing) {
    std::vector<HalfEdgeId> left(outgoing);  // in no fan yet
    std::sort(left.begin(), left.end());
    const auto take = [&](HalfEdgeId h) {
      const auto at = std::lower_bound(left.begin(), left.end(), h);
      if (at == left.end() || *at != h) return false;
      left.erase(at);
      return true;
    };
    bool first = true;
    for (const HalfEdgeId start : outgoing) {
      if (!take(start)) continue;
      const VertexId own = first ? v : copy_of(v);
      first = false;
      HalfEdgeId h = start;
      do {
        take(h);
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
  std::vector<VertexId> vertices_;                 // ascending
  std::vector<std::vector<HalfEdgeId>> outgoing_;  // by index in vertices_
};

// The sides of new faces: open half-edges that are there, and one new edge for two opposite sides.
class SidesOfNewFaces {
  struct Side {
    VertexId from, to;
    HalfEdgeId half_edge;  // not valid where there is none yet
    std::pair<VertexId, VertexId> key() const { return {from, to}; }
  };

 public:
  SidesOfNewFaces(HalfEdges& m, FansAtVertices& fans, std::span<const FaceCorners> faces)
      : m_(m), fans_(fans) {
    for (const FaceCorners& c : faces) {
      for (size_t i = 0; i < 3; ++i)
        sides_.push_back({c[i], c[(i + 1) % 3], open_half_edge(m_, c[i], c[(i + 1) % 3])});
    }
    std::ranges::sort(sides_, {}, &Side::key);
  }

  HalfEdgeId side(VertexId from, VertexId to) {
    Side* const own = find(from, to);
    KERF_ASSERT(own);
    if (!own->half_edge.valid()) {
      own->half_edge = m_.add_edge(from, to);
      fans_.add(from, own->half_edge);
      fans_.add(to, opposite(own->half_edge));
      if (Side* const other = find(to, from)) other->half_edge = opposite(own->half_edge);
    }
    KERF_ASSERT(!m_.face(own->half_edge).valid());
    return own->half_edge;
  }

 private:
  Side* find(VertexId from, VertexId to) {
    const auto at = std::ranges::lower_bound(sides_, std::pair(from, to), {}, &Side::key);
    return at != sides_.end() && at->key() == std::pair(from, to) ? &*at : nullptr;
  }

  HalfEdges& m_;
  FansAtVertices& fans_;
  std::vector<Side> sides_;  // ascending
};

}  // namespace

VertexId Mesh::add_vertex(const Vec3& position) { return kernel_->half_edges.add_vertex(position); }

std::vector<FaceId> Mesh::add_faces(std::span<const FaceCorners> corners, std::span<const FaceData> data) {
  KERF_ASSERT(corners.size() == data.size());
  Kernel& k = *kernel_;
  HalfEdges& m = k.half_edges;
  FansAtVertices fans(k, corners);
  SidesOfNewFaces sides(m, fans, corners);
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
