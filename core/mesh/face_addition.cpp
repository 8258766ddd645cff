#include <algorithm>
#include <array>
#include <cassert>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/mesh/half_edges_internal.h"
#include "core/mesh/mesh.h"

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

VertexId add_copy_of(Mesh::Kernel& kernel, VertexId v) {
  const VertexId copy = kernel.half_edges.add_vertex(Vec3(kernel.half_edges.position(v)));
  if (!kernel.colours.blank()) kernel.colours.set(copy, kernel.colours.get(v));
  return copy;
}

}  // namespace

Mesh extract_mesh(const Mesh& mesh, std::span<const FaceId> faces) {
  assert(std::is_sorted(faces.begin(), faces.end()));
  assert(std::all_of(faces.begin(), faces.end(), [&](FaceId f) { return mesh.is_live(f); }));
  return Extraction(mesh, faces).run();
}

FaceAddition::FaceAddition(std::vector<VertexId> vertices, std::vector<std::array<uint32_t, 3>> corners)
    : vertices_(std::move(vertices)),
      corners_(std::move(corners)),
      is_noted_(vertices_.size()),
      chains_(vertices_.size()) {}

void FaceAddition::append(uint32_t v, HalfEdgeId h) {
  const auto entry = static_cast<uint32_t>(entries_.size());
  entries_.push_back({h, kNone});
  Chain& chain = chains_[v];
  (chain.first == kNone ? chain.first : entries_[chain.last].next) = entry;
  chain.last = entry;
  ++chain.count;
}

// Lists the half-edges at a vertex before a face is added there; later they may be unreachable from the mesh.
void FaceAddition::record_half_edges(const Mesh::Kernel& kernel, uint32_t v) {
  if (is_noted_[v]) return;
  is_noted_[v] = true;
  kernel.half_edges.for_each_outgoing(vertices_[v], [&](HalfEdgeId h) { append(v, h); });
}

// Returns an existing open half-edge, or one of a new edge. Searches at the end with fewer half-edges,
// because the other one may be the hub of many faces.
HalfEdgeId FaceAddition::side(Mesh::Kernel& kernel, uint32_t from, uint32_t to) {
  HalfEdges& m = kernel.half_edges;
  const bool from_start = chains_[from].count <= chains_[to].count;
  const VertexId other = vertices_[from_start ? to : from];
  HalfEdgeId found;
  for_each_at(from_start ? from : to, [&](HalfEdgeId h) {
    const HalfEdgeId along = from_start ? h : opposite(h);
    if (!found.valid() && m.to(h) == other && !m.face(along).valid()) found = along;
  });
  if (found.valid()) return found;
  const HalfEdgeId made = m.add_edge(vertices_[from], vertices_[to]);
  append(from, made);
  append(to, opposite(made));
  return made;
}

// Links each boundary half-edge that ends at a vertex to the one that bounds the same fan on its other side,
// and sets the vertex's outgoing half-edge if it has none.
void FaceAddition::link_boundaries(Mesh::Kernel& kernel, uint32_t v) const {
  HalfEdges& m = kernel.half_edges;
  if (!m.outgoing(vertices_[v]).valid()) m.set_outgoing(vertices_[v], entries_[chains_[v].first].half_edge);
  for_each_at(v, [&](HalfEdgeId h) {
    const HalfEdgeId boundary = opposite(h);
    if (m.face(boundary).valid()) return;
    HalfEdgeId after = h;
    while (m.face(after).valid()) after = opposite(m.previous(after));
    m.link(boundary, after);
  });
}

std::vector<FaceId> FaceAddition::add(Mesh& mesh, std::span<const FaceData> data) {
  KERF_ASSERT(data.size() <= faces() - added_);
  Mesh::Kernel& k = *mesh.kernel_;
  HalfEdges& m = k.half_edges;
  std::vector<FaceId> added;
  std::vector<uint32_t> touched;
  for (const FaceData& of_face : data) {
    const auto& corners = corners_[added_++];
    for (const uint32_t v : corners) record_half_edges(k, v);
    const HalfEdgeId ab = side(k, corners[0], corners[1]), bc = side(k, corners[1], corners[2]),
                     ca = side(k, corners[2], corners[0]);
    const FaceId f = m.add_face(ab);
    m.close(f, ab, bc, ca);
    k.faces.push_back(of_face);
    k.faces.edit(f.index).base = f;
    added.push_back(f);
    touched.insert(touched.end(), corners.begin(), corners.end());
  }
  k.live_faces += static_cast<uint32_t>(added.size());
  if (!k.rings.empty()) add_isolated_rings(k);
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const uint32_t v : touched) link_boundaries(k, v);
  return added;
}

void FaceAddition::weld(Mesh& mesh, uint32_t v, VertexId other, std::vector<FaceId>& changed) {
  HalfEdges& m = mesh.kernel_->half_edges;
  KERF_ASSERT(added_ == 0 && m.position(other) == m.position(vertices_[v]));
  record_half_edges(*mesh.kernel_, v);
  std::vector<HalfEdgeId> moved;
  m.for_each_outgoing(other, [&](HalfEdgeId h) { moved.push_back(h); });
  for (const HalfEdgeId h : moved) {
    m.set_to(opposite(h), vertices_[v]);
    append(v, h);
    if (m.face(h).valid()) changed.push_back(m.face(h));
  }
  m.set_outgoing(other, HalfEdgeId());
}

uint32_t FaceAddition::index_of(VertexId v) const {
  return static_cast<uint32_t>(std::ranges::lower_bound(vertices_, v) - vertices_.begin());
}

// Moves the face of a half-edge to a new edge with the same ends, and returns its half-edge there.
HalfEdgeId FaceAddition::part_from(Mesh::Kernel& kernel, HalfEdgeId side) {
  HalfEdges& m = kernel.half_edges;
  const HalfEdgeId own = m.add_edge(m.from(side), m.to(side));
  append(index_of(m.from(side)), own);
  append(index_of(m.to(side)), opposite(own));
  const FaceId f = m.face(side);
  const HalfEdgeId next = m.next(side), previous = m.previous(side);
  m.set_face(side, FaceId());
  m.close(f, own, next, previous);
  return own;
}

// Each edge of a ring stays in the ring of the other sides, moves to the ring of the listed ones, or, if it
// has a face of either kind, is replaced by one edge in each.
void FaceAddition::open(Mesh& mesh, std::span<const Mesh::Side> sides) {
  Mesh::Kernel& k = *mesh.kernel_;
  HalfEdges& m = k.half_edges;
  for (uint32_t v = 0; v < vertices_.size(); ++v) record_half_edges(k, v);
  std::vector<HalfEdgeId> listed;
  for (const Mesh::Side& s : sides) {
    HalfEdgeId h = m.first(s.face);
    while (m.from(h) != s.from) h = m.next(h);
    KERF_ASSERT(m.to(h) == s.to);
    listed.push_back(h);
  }
  std::sort(listed.begin(), listed.end());
  std::unordered_set<uint32_t> visited;  // edges; never iterated
  std::vector<HalfEdgeId> ring, staying, leaving;
  for (const HalfEdgeId start : listed) {
    if (visited.contains(edge_of(start).index)) continue;
    ring.assign(1, start);
    for (HalfEdgeId h = next_in_ring(k, start); h != start; h = next_in_ring(k, h)) ring.push_back(h);
    staying.clear();
    leaving.clear();
    for (const HalfEdgeId h : ring) {
      visited.insert(edge_of(h).index);
      const HalfEdgeId o = opposite(h);
      const bool h_leaves = std::ranges::binary_search(listed, h),
                 o_leaves = std::ranges::binary_search(listed, o);
      const bool h_stays = !h_leaves && m.face(h).valid(), o_stays = !o_leaves && m.face(o).valid();
      if (h_stays || o_stays) staying.push_back(h);
      if (!h_leaves && !o_leaves) continue;
      if (!h_stays && !o_stays) {
        leaving.push_back(h);
      } else {
        leaving.push_back(h_leaves ? part_from(k, h) : opposite(part_from(k, o)));
      }
    }
    if (ring.size() == 1) continue;
    if (!staying.empty()) link_ring(k, staying);
    link_ring(k, leaving);
  }
  if (!k.rings.empty()) add_isolated_rings(k);
  for (uint32_t v = 0; v < vertices_.size(); ++v) link_boundaries(k, v);
}

bool FaceAddition::is_one_fan(const Mesh::Kernel& kernel, uint32_t v) const {
  const HalfEdges& m = kernel.half_edges;
  size_t listed = 0, around = 0;
  for_each_at(v, [&](HalfEdgeId) { ++listed; });
  const HalfEdgeId start = entries_[chains_[v].first].half_edge;
  HalfEdgeId h = start;
  do {
    ++around;
    h = m.next(opposite(h));
  } while (h != start);
  return around == listed;
}

void FaceAddition::part_fans_at(Mesh::Kernel& kernel, uint32_t v, std::vector<FaceId>& changed) const {
  HalfEdges& m = kernel.half_edges;
  std::vector<HalfEdgeId> all;
  for_each_at(v, [&](HalfEdgeId h) { all.push_back(h); });
  std::sort(all.begin(), all.end());
  std::vector<bool> taken(all.size());  // already in a fan
  const auto take = [&](HalfEdgeId h) {
    const auto at = std::lower_bound(all.begin(), all.end(), h);
    if (at == all.end() || *at != h || taken[static_cast<size_t>(at - all.begin())]) return false;
    taken[static_cast<size_t>(at - all.begin())] = true;
    return true;
  };
  bool first = true;
  for_each_at(v, [&](HalfEdgeId start) {
    if (!take(start)) return;
    const bool is_kept = std::exchange(first, false);
    const VertexId own = is_kept ? vertices_[v] : add_copy_of(kernel, vertices_[v]);
    HalfEdgeId h = start;
    do {
      take(h);
      m.set_to(opposite(h), own);
      if (!is_kept && m.face(h).valid()) changed.push_back(m.face(h));
      h = m.next(opposite(h));
    } while (h != start);
    m.set_outgoing(own, start);
  });
}

bool FaceAddition::split_fans(Mesh& mesh, size_t most, std::vector<FaceId>& changed) {
  KERF_ASSERT(added_ == faces());
  Mesh::Kernel& k = *mesh.kernel_;
  const size_t end = std::min(parted_ + most, vertices_.size());
  for (; parted_ < end; ++parted_) {
    const auto v = static_cast<uint32_t>(parted_);
    if (chains_[v].first == kNone) continue;
    if (is_one_fan(k, v)) {
      k.half_edges.set_outgoing(vertices_[v], entries_[chains_[v].first].half_edge);
    } else {
      part_fans_at(k, v, changed);
    }
  }
  return parted_ == vertices_.size();
}

void Mesh::open_edges(std::span<const Side> sides, std::vector<FaceId>& changed) {
  std::vector<VertexId> vertices;
  for (const Side& s : sides) vertices.insert(vertices.end(), {s.from, s.to});
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const size_t count = vertices.size();
  FaceAddition opening(std::move(vertices), {});
  opening.open(*this, sides);
  opening.split_fans(*this, count, changed);
}

VertexId Mesh::add_vertex(const Vec3& position) { return kernel_->half_edges.add_vertex(position); }

std::vector<FaceId> Mesh::add_faces(std::span<const std::array<VertexId, 3>> corners,
                                    std::span<const FaceData> data) {
  KERF_ASSERT(corners.size() == data.size());
  std::vector<VertexId> vertices;
  for (const auto& c : corners) vertices.insert(vertices.end(), c.begin(), c.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto index = [&](VertexId v) {
    return static_cast<uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  };
  std::vector<std::array<uint32_t, 3>> local;
  for (const auto& c : corners) local.push_back({index(c[0]), index(c[1]), index(c[2])});
  FaceAddition addition(vertices, std::move(local));
  const std::vector<FaceId> added = addition.add(*this, data);
  std::vector<FaceId> changed;
  addition.split_fans(*this, vertices.size(), changed);
  return added;
}

}  // namespace kerf
