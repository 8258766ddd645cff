#include <algorithm>
#include <cassert>

#include "core/mesh/half_edges_internal.h"

namespace kerf {

VertexId HalfEdges::add_vertex(const Vec3& position) {
  positions_.push_back(position);
  outgoing_.push_back(HalfEdgeId());
  return VertexId(vertices() - 1);
}

HalfEdgeId HalfEdges::add_edge(VertexId from, VertexId to) {
  assert(from != to && from.index < vertices() && to.index < vertices());
  const HalfEdgeId h(links_.size());
  links_.push_back({to, {}, {}, {}});
  links_.push_back({from, {}, {}, {}});
  return h;
}

FaceId HalfEdges::add_face(HalfEdgeId first) {
  first_.push_back(first);
  return FaceId(faces() - 1);
}

void HalfEdges::close(FaceId f, HalfEdgeId a, HalfEdgeId b, HalfEdgeId c) {
  assert(to(a) == from(b) && to(b) == from(c) && to(c) == from(a));
  Links &first = links_.edit(a.index), &second = links_.edit(b.index), &third = links_.edit(c.index);
  first = {first.to, b, c, f};
  second = {second.to, c, a, f};
  third = {third.to, a, b, f};
  first_.edit(f.index) = a;
}

void HalfEdges::grow_to(uint32_t vertices, uint32_t edges, uint32_t faces) {
  links_.grow_to(2 * edges);
  positions_.grow_to(vertices);
  outgoing_.grow_to(vertices);
  first_.grow_to(faces);
}

void HalfEdges::set_face_sides(FaceId f, const std::array<HalfEdgeId, 3>& sides,
                               const std::array<VertexId, 3>& corners) {
  const auto [a, b, c] = sides;
  links_.edit(a.index) = {corners[1], b, c, f};
  links_.edit(b.index) = {corners[2], c, a, f};
  links_.edit(c.index) = {corners[0], a, b, f};
  first_.edit(f.index) = a;
}

VertexId HalfEdges::split(EdgeId e, const Vec3& at) {
  const HalfEdgeId h = half_edge(e, 0), o = half_edge(e, 1);
  assert(face(h).valid() || face(o).valid());
  const VertexId tail = to(o), middle = add_vertex(at);
  const HalfEdgeId outward = add_edge(middle, tail), inward = opposite(outward);
  set_to(o, middle);
  set_outgoing(middle, h);

  if (const FaceId left = face(h); left.valid()) {
    const HalfEdgeId h1 = next(h), h2 = next(h1);
    const HalfEdgeId bisector = add_edge(middle, to(h1));
    const FaceId added = add_face(h2);
    close(left, h, h1, opposite(bisector));
    close(added, h2, inward, bisector);
  } else {
    link(previous(h), inward);
    link(inward, h);
  }
  if (const FaceId right = face(o); right.valid()) {
    const HalfEdgeId o1 = next(o), o2 = next(o1);
    const HalfEdgeId bisector = add_edge(middle, to(o1));
    const FaceId added = add_face(o1);
    close(right, o, bisector, o2);
    close(added, o1, opposite(bisector), outward);
  } else {
    link(outward, next(o));
    link(o, outward);
  }
  if (outgoing(tail) == h) set_outgoing(tail, inward);
  return middle;
}

void HalfEdges::remove(FaceId f) {
  assert(first(f).valid());
  const HalfEdgeId a = first(f), b = next(a), c = next(b);
  assert(next(c) == a);
  first_.edit(f.index) = HalfEdgeId();
  for (const HalfEdgeId h : {a, b, c}) open(h);
  for (const HalfEdgeId h : {a, b, c}) {
    if (!face(opposite(h)).valid()) remove_edge(edge_of(h));
  }
}

// Removes an edge without faces and joins the boundaries on its two sides.
void HalfEdges::remove_edge(EdgeId e) {
  const HalfEdgeId h = half_edge(e, 0), o = half_edge(e, 1);
  assert(!face(h).valid() && !face(o).valid());
  const HalfEdgeId after_h = next(h), after_o = next(o), before_h = previous(h), before_o = previous(o);
  link(before_h, after_o);
  link(before_o, after_h);
  leave(to(h), o, after_h);
  leave(to(o), h, after_o);
}

// Unlinks a half-edge from its start vertex. `other` also starts there; both are equal if it is the last.
void HalfEdges::leave(VertexId v, HalfEdgeId removed, HalfEdgeId other) {
  if (outgoing(v) == removed) set_outgoing(v, other == removed ? HalfEdgeId() : other);
}

void HalfEdges::prefetch(FaceId f, int turn) const {
  assert(turn >= 0 && turn < kTurns);
  if (turn == 0) return first_.prefetch(f.index);
  const HalfEdgeId a = first(f);
  if (!a.valid()) return;
  if (turn == 1) return links_.prefetch(a.index);
  links_.prefetch(next(a).index);
  links_.prefetch(previous(a).index);
  positions_.prefetch(from(a).index);
  positions_.prefetch(to(a).index);
}

size_t HalfEdges::bytes() const { return ChangeOfParts<HalfEdges>::bytes_of(*this); }

// A changed side of a face leads to the face in both states. So does a moved vertex: a face that has the
// vertex in one state only has changed sides.
void HalfEdges::Change::append_faces(const HalfEdges& mesh, std::vector<FaceId>& out) const {
  const auto append_ends = [&](uint32_t now, uint32_t other) {
    for (uint32_t f = std::min(now, other); f < std::max(now, other); ++f) out.emplace_back(f);
  };
  append_ends(mesh.faces(), part_at<kFirst>().records().size());
  part_at<kFirst>().records().for_each_page([&](uint32_t first, std::span<const HalfEdgeId> page) {
    append_ends(first, first + static_cast<uint32_t>(page.size()));
  });
  part_at<kLinks>().records().for_each_page([&](uint32_t first, std::span<const Links> page) {
    for (uint32_t i = 0; i < page.size(); ++i) {
      out.push_back(page[i].face);
      if (first + i < mesh.links_.size()) out.push_back(mesh.links_[first + i].face);
    }
  });
  part_at<kPositions>().records().for_each_page([&](uint32_t first, std::span<const Vec3> page) {
    const uint32_t end = std::min(first + static_cast<uint32_t>(page.size()), mesh.vertices());
    for (uint32_t v = first; v < end; ++v) {
      if (mesh.position(VertexId(v)) == page[v - first]) continue;
      mesh.for_each_outgoing(VertexId(v), [&](HalfEdgeId h) { out.push_back(mesh.face(h)); });
    }
  });
}

namespace {

// Sets one link of the edge of `at`. Precondition: `at` and `target` have the same direction.
void set_link(Mesh::Kernel& k, HalfEdgeId at, HalfEdgeId RingLink::*side, HalfEdgeId target) {
  const EdgeId edge = edge_of(at);
  assert(edge.index < k.rings.size());
  const bool aligned = at == half_edge(edge, 0);
  k.rings.edit(edge.index).*side = aligned ? target : opposite(target);
}

constexpr size_t kPositionsOfRange = 1 << 14;  // or triangles

uint32_t next_side(uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
uint32_t previous_side(uint32_t side) { return side % 3 == 0 ? side + 2 : side - 1; }

class FanFinder {
 public:
  FanFinder(std::vector<std::array<uint32_t, 3>>& triangles, size_t positions,
            std::span<const uint32_t> partner)
      : triangles_(triangles), partner_(partner), at_(positions) {}

  Result<VertexFans> run(const Progress* progress) {
    ProgressShares shares(progress);
    const Progress counting = shares.next(0.2), walking = shares.next(0.5), naming = shares.next(0.3);
    count_sides();
    if (!counting.report(1)) return cancelled();
    const auto walk = [&](size_t p, size_t end) {
      for (; p < end; ++p) at_[p].fans = fans_at(static_cast<uint32_t>(p));
    };
    if (!for_each_range(at_.size(), kPositionsOfRange, &walking, walk)) return cancelled();
    number_fans_of_shared_positions();
    number_vertices();
    const auto rename = [&](size_t t, size_t end) {
      for (; t < end; ++t) rename_corners(t);
    };
    if (!for_each_range(triangles_.size(), kPositionsOfRange, &naming, rename)) return cancelled();
    return std::move(vertices_);
  }

 private:
  // Value of `fans` for a position with several fans, until they are numbered.
  static constexpr uint32_t kSeveral = 0xffffffffu;

  // The sides that start at a position, and later its vertices.
  struct Position {
    uint32_t sides = 0;
    uint32_t first_side = kNoSide, last_side = 0;
    uint32_t fans = 0;
    uint32_t first_vertex = 0;
  };

  uint32_t tail(uint32_t side) const { return triangles_[side / 3][side % 3]; }

  void count_sides() {
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      Position& p = at_[tail(s)];
      ++p.sides;
      if (p.first_side == kNoSide) p.first_side = s;
      p.last_side = s;
    }
  }

  // Calls visit(side) for each side of the fan of `start`.
  template <typename Visit>
  void walk_fan(uint32_t start, Visit visit) const {
    uint32_t s = start;
    do {
      visit(s);
      if (partner_[s] == kNoSide) break;
      s = next_side(partner_[s]);
    } while (s != start);
    if (partner_[s] != kNoSide) return;  // the fan is closed
    for (s = partner_[previous_side(start)]; s != kNoSide; s = partner_[previous_side(s)]) visit(s);
  }

  uint32_t fans_at(uint32_t p) const {
    const Position& position = at_[p];
    if (position.sides == 0) return 0;
    uint32_t sides = 0;
    walk_fan(position.first_side, [&](uint32_t) { ++sides; });
    return sides == position.sides ? 1 : kSeveral;
  }

  // Numbers the fans from 0 at each position with several, in the order of their lowest sides.
  void number_fans_of_shared_positions() {
    shared_at_.assign(at_.size(), kNoSide);
    for (uint32_t p = 0; p < at_.size(); ++p) {
      if (at_[p].fans != kSeveral) continue;
      shared_at_[p] = static_cast<uint32_t>(shared_.size());
      shared_.push_back({p, {}});
      at_[p].fans = 0;
    }
    if (shared_.empty()) return;
    fan_of_.assign(partner_.size(), kNoSide);
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (shared_at_[tail(s)] != kNoSide && fan_of_[s] == kNoSide) number_fan(s);
    }
  }
  void number_fan(uint32_t lowest_side) {
    Shared& here = shared_[shared_at_[tail(lowest_side)]];
    const uint32_t fan = at_[here.position].fans++;
    uint32_t last = lowest_side;
    walk_fan(lowest_side, [&](uint32_t side) {
      fan_of_[side] = fan;
      last = std::max(last, side);
    });
    here.last_sides.push_back(last);
  }

  void number_vertices() {
    uint32_t vertices = 0;
    for (Position& p : at_) {
      p.first_vertex = vertices;
      vertices += p.fans;
    }
    vertices_.position.resize(vertices);
    vertices_.last_side.resize(vertices);
    for_each_range(at_.size(), kPositionsOfRange, [&](size_t p, size_t end) {
      for (; p < end; ++p) {
        for (uint32_t v = 0; v < at_[p].fans; ++v) {
          vertices_.position[at_[p].first_vertex + v] = static_cast<uint32_t>(p);
          vertices_.last_side[at_[p].first_vertex + v] = at_[p].last_side;
        }
      }
    });
    for (const Shared& s : shared_) {
      std::copy(s.last_sides.begin(), s.last_sides.end(),
                vertices_.last_side.begin() + at_[s.position].first_vertex);
    }
  }

  void rename_corners(size_t t) {
    for (uint32_t i = 0; i < 3; ++i) {
      uint32_t& corner = triangles_[t][i];
      const Position& p = at_[corner];
      corner = p.first_vertex + (p.fans > 1 ? fan_of_[3 * t + i] : 0);
    }
  }

  std::vector<std::array<uint32_t, 3>>& triangles_;
  std::span<const uint32_t> partner_;
  std::vector<Position> at_;
  struct Shared {
    uint32_t position;
    std::vector<uint32_t> last_sides;  // by fan
  };
  std::vector<Shared> shared_;       // positions with several fans, ascending
  std::vector<uint32_t> shared_at_;  // by position: its index in shared_, or kNoSide
  std::vector<uint32_t> fan_of_;     // by side that starts at such a position: its fan there; empty without
  VertexFans vertices_;
};

constexpr size_t kTrianglesPerRange = 1 << 14;  // per range

class HalfEdgeFilling {
 public:
  HalfEdgeFilling(HalfEdges& half_edges, std::span<const std::array<uint32_t, 3>> triangles,
                  std::span<const uint32_t> partner, std::span<const uint32_t> last_side)
      : m_(half_edges), triangles_(triangles), partner_(partner), last_side_(last_side) {}

  Result<std::vector<HalfEdgeId>> run(const Progress* progress) {
    ProgressShares shares(progress);
    const Progress naming = shares.next(0.3), linking = shares.next(0.7);
    const uint32_t edges = count_edges();
    m_.grow_to(static_cast<uint32_t>(last_side_.size()), edges, static_cast<uint32_t>(triangles_.size()));
    half_edge_.resize(partner_.size());
    const auto name = [&](size_t t, size_t end) { name_edges(t, end); };
    if (!for_each_range(triangles_.size(), kTrianglesPerRange, &naming, name)) return cancelled();
    const auto link = [&](size_t t, size_t end) {
      for (; t < end; ++t) link_triangle(static_cast<uint32_t>(t));
    };
    if (!for_each_range(triangles_.size(), kTrianglesPerRange, &linking, link)) return cancelled();
    for_each_range(last_side_.size(), kTrianglesPerRange, [&](size_t v, size_t end) {
      for (; v < end; ++v) m_.set_outgoing(VertexId(static_cast<uint32_t>(v)), half_edge_[last_side_[v]]);
    });
    close_boundaries();
    return std::move(half_edge_);
  }

 private:
  // Returns true if the side defines its edge, i.e. is the lower of its two sides.
  bool names_edge(size_t side) const { return partner_[side] == kNoSide || partner_[side] > side; }

  uint32_t count_edges() {
    edges_before_.assign(range_count(triangles_.size(), kTrianglesPerRange) + 1, 0);
    for_each_range(triangles_.size(), kTrianglesPerRange, [&](size_t t, size_t end) {
      uint32_t edges = 0;
      for (size_t s = 3 * t; s < 3 * end; ++s) edges += names_edge(s);
      edges_before_[t / kTrianglesPerRange + 1] = edges;
    });
    for (size_t r = 1; r < edges_before_.size(); ++r) edges_before_[r] += edges_before_[r - 1];
    return edges_before_.back();
  }

  void name_edges(size_t triangle, size_t end) {
    uint32_t edge = edges_before_[triangle / kTrianglesPerRange];
    for (size_t s = 3 * triangle; s < 3 * end; ++s) {
      if (!names_edge(s)) continue;
      half_edge_[s] = half_edge(EdgeId(edge++), 0);
      if (partner_[s] != kNoSide) half_edge_[partner_[s]] = opposite(half_edge_[s]);
    }
  }

  void link_triangle(uint32_t t) {
    const size_t s = 3 * size_t{t};
    const std::array<VertexId, 3> corners = {VertexId(triangles_[t][0]), VertexId(triangles_[t][1]),
                                             VertexId(triangles_[t][2])};
    m_.set_face_sides(FaceId(t), {half_edge_[s], half_edge_[s + 1], half_edge_[s + 2]}, corners);
    for (size_t i = 0; i < 3; ++i) {
      if (partner_[s + i] == kNoSide) m_.set_open(opposite(half_edge_[s + i]), corners[i]);
    }
  }

  // A vertex has one fan, so at most one boundary half-edge starts there; it continues the boundary.
  void close_boundaries() {
    std::vector<HalfEdgeId> outer;
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (partner_[s] == kNoSide) outer.push_back(opposite(half_edge_[s]));
    }
    if (outer.empty()) return;
    std::vector<HalfEdgeId> starts(last_side_.size());
    for (const HalfEdgeId h : outer) starts[m_.from(h).index] = h;
    for (const HalfEdgeId h : outer) {
      assert(starts[m_.to(h).index].valid());
      m_.link(h, starts[m_.to(h).index]);
    }
  }

  HalfEdges& m_;
  std::span<const std::array<uint32_t, 3>> triangles_;
  std::span<const uint32_t> partner_, last_side_;
  std::vector<uint32_t> edges_before_;  // by range of triangles
  std::vector<HalfEdgeId> half_edge_;   // by side
};

}  // namespace

HalfEdgeId next_in_ring(const Mesh::Kernel& k, HalfEdgeId h) {
  if (k.rings.empty()) return h;
  const EdgeId e = edge_of(h);
  const HalfEdgeId next = k.rings[e.index].next;
  return h == half_edge(e, 0) ? next : opposite(next);
}

HalfEdgeId previous_in_ring(const Mesh::Kernel& k, HalfEdgeId h) {
  if (k.rings.empty()) return h;
  const EdgeId e = edge_of(h);
  const HalfEdgeId previous = k.rings[e.index].previous;
  return h == half_edge(e, 0) ? previous : opposite(previous);
}

void leave_ring(Mesh::Kernel& k, EdgeId e) {
  if (k.rings.empty()) return;
  const HalfEdgeId self = half_edge(e, 0);
  const RingLink link = k.rings[e.index];
  if (link.next == self) return;
  set_link(k, link.previous, &RingLink::next, link.next);
  set_link(k, link.next, &RingLink::previous, link.previous);
  k.rings.edit(e.index) = {self, self};
}

void join_ring(Mesh::Kernel& k, HalfEdgeId h, HalfEdgeId member) {
  assert(next_in_ring(k, h) == h);
  assert(k.half_edges.position(k.half_edges.from(h)) == k.half_edges.position(k.half_edges.from(member)));
  assert(k.half_edges.position(k.half_edges.to(h)) == k.half_edges.position(k.half_edges.to(member)));
  const HalfEdgeId after = next_in_ring(k, member);
  set_link(k, h, &RingLink::previous, member);
  set_link(k, h, &RingLink::next, after);
  set_link(k, member, &RingLink::next, h);
  set_link(k, after, &RingLink::previous, h);
}

void add_isolated_rings(Mesh::Kernel& k) {
  for (uint32_t e = k.rings.size(); e < k.half_edges.edges(); ++e) {
    const HalfEdgeId self = half_edge(EdgeId(e), 0);
    k.rings.push_back({self, self});
  }
}

void link_ring(Mesh::Kernel& k, const std::vector<HalfEdgeId>& members) {
  add_isolated_rings(k);
  for (size_t i = 0; i < members.size(); ++i) {
    const HalfEdgeId h = members[i];
    assert(k.half_edges.position(k.half_edges.to(h)) == k.half_edges.position(k.half_edges.to(members[0])));
    HalfEdgeId next = members[(i + 1) % members.size()];
    HalfEdgeId previous = members[(i + members.size() - 1) % members.size()];
    const EdgeId e = edge_of(h);
    if (h != half_edge(e, 0)) {
      next = opposite(next);
      previous = opposite(previous);
    }
    k.rings.edit(e.index) = {next, previous};
  }
}

Result<VertexFans> name_vertices(std::vector<std::array<uint32_t, 3>>& triangles, size_t positions,
                                 std::span<const uint32_t> partner, const Progress* progress) {
  assert(partner.size() == 3 * triangles.size());
  return FanFinder(triangles, positions, partner).run(progress);
}

Result<std::vector<HalfEdgeId>> fill_half_edges(HalfEdges& half_edges,
                                                std::span<const std::array<uint32_t, 3>> triangles,
                                                std::span<const uint32_t> partner,
                                                std::span<const uint32_t> last_side,
                                                const Progress* progress) {
  assert(half_edges.faces() == 0 && partner.size() == 3 * triangles.size());
  return HalfEdgeFilling(half_edges, triangles, partner, last_side).run(progress);
}

}  // namespace kerf
