#include "core/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <unordered_map>
#include <vector>

#include "core/mesh/half_edges_internal.h"

namespace kerf {

namespace {

class Extraction {
 public:
  Extraction(const Mesh& mesh, std::span<const FaceId> faces)
      : old_(mesh.kernel()), from_(old_.half_edges), to_(mesh_.kernel()), faces_(faces) {}

  Mesh run() {
    name_edges();
    name_vertices();
    make_edges();
    make_faces();
    close_boundaries();
    copy_rings();
    copy_data();
    return std::move(mesh_);
  }

 private:
  static std::array<HalfEdgeId, 3> sides(const HalfEdges& m, FaceId f) {
    const HalfEdgeId h = m.first(f);
    return {h, m.next(h), m.previous(h)};
  }

  HalfEdgeId named(HalfEdgeId h) const {
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), edge_of(h));
    assert(at != edges_.end() && *at == edge_of(h));
    return half_edge(EdgeId(static_cast<uint32_t>(at - edges_.begin())), h.index & 1);
  }

  void name_edges() {
    edges_.reserve(3 * faces_.size());
    for (const FaceId f : faces_) {
      for (const HalfEdgeId h : sides(from_, f)) edges_.push_back(edge_of(h));
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  // Gives each fan of faces around a vertex a vertex of its own.
  void name_vertices() {
    starts_.resize(2 * edges_.size());
    for (const FaceId f : faces_) {
      for (const HalfEdgeId h : sides(from_, f)) {
        if (!starts_[named(h).index].valid()) name_fan(h);
      }
    }
  }
  void name_fan(HalfEdgeId start) {
    const VertexId old = from_.from(start), v = to_.half_edges.add_vertex(from_.position(old));
    if (!old_.colours.blank()) to_.colours.set(v, old_.colours.get(old));
    const auto name = [&](HalfEdgeId h) { starts_[named(h).index] = v; };
    HalfEdgeId h = start;
    do {
      name(h);
      if (!from_.face(h).valid()) break;
      h = opposite(from_.previous(h));
    } while (h != start);
    if (from_.face(h).valid()) return;  // the fan is closed
    for (h = opposite(start); from_.face(h).valid(); h = opposite(from_.next(h))) name(from_.next(h));
  }

  void make_edges() {
    for (uint32_t e = 0; e < edges_.size(); ++e) {
      const HalfEdgeId h = to_.half_edges.add_edge(starts_[2 * e], starts_[2 * e + 1]);
      to_.half_edges.set_outgoing(starts_[2 * e], h);
      to_.half_edges.set_outgoing(starts_[2 * e + 1], opposite(h));
    }
  }

  void make_faces() {
    for (const FaceId f : faces_) {
      const auto [a, b, c] = sides(from_, f);
      to_.half_edges.close(to_.half_edges.add_face(named(a)), named(a), named(b), named(c));
    }
    to_.live_faces = static_cast<uint32_t>(faces_.size());
  }

  // Links each boundary half-edge to the one that bounds the same fan on its other side.
  void close_boundaries() {
    HalfEdges& m = to_.half_edges;
    for (uint32_t i = 0; i < 2 * m.edges(); ++i) {
      const HalfEdgeId h(i);
      if (m.face(h).valid()) continue;
      HalfEdgeId after = opposite(h);
      while (m.face(after).valid()) after = opposite(m.previous(after));
      m.link(h, after);
    }
  }

  void copy_rings() {
    const auto alone = [&](EdgeId e) { return next_in_ring(old_, half_edge(e, 0)) == half_edge(e, 0); };
    if (std::all_of(edges_.begin(), edges_.end(), alone)) return;
    for (const EdgeId e : edges_) {
      const HalfEdgeId h = half_edge(e, 0);
      to_.rings.push_back({named(next_in_ring(old_, h)), named(previous_in_ring(old_, h))});
    }
  }

  void copy_data() {
    std::unordered_map<uint32_t, FaceId> first_of_base;  // never iterated
    for (uint32_t i = 0; i < faces_.size(); ++i) {
      FaceData data = old_.faces[faces_[i].index];
      const FaceId own(i);
      data.base = data.halvings == 0 ? own : first_of_base.try_emplace(data.base.index, own).first->second;
      data.element = FaceData::kNoElement;
      to_.faces.push_back(data);
    }
    to_.columns = old_.columns.extract(faces_);
  }

  const Mesh::Kernel& old_;
  const HalfEdges& from_;
  Mesh mesh_;
  Mesh::Kernel& to_;
  std::span<const FaceId> faces_;
  std::vector<EdgeId> edges_;     // the old edges, ascending; the index is the new edge
  std::vector<VertexId> starts_;  // by new half-edge: the vertex at which it starts
};

}  // namespace

Mesh extract_mesh(const Mesh& mesh, std::span<const FaceId> faces) {
  assert(std::is_sorted(faces.begin(), faces.end()));
  assert(std::all_of(faces.begin(), faces.end(), [&](FaceId f) { return mesh.is_live(f); }));
  return Extraction(mesh, faces).run();
}

}  // namespace kerf
