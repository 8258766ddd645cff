#include "core/mesh/half_edges.h"

#include <algorithm>
#include <cassert>
#include <span>

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

// Removes an edge without faces; the boundaries on both of its sides are joined.
void HalfEdges::remove_edge(EdgeId e) {
  const HalfEdgeId h = half_edge(e, 0), o = half_edge(e, 1);
  assert(!face(h).valid() && !face(o).valid());
  const HalfEdgeId after_h = next(h), after_o = next(o), before_h = previous(h), before_o = previous(o);
  link(before_h, after_o);
  link(before_o, after_h);
  leave(to(h), o, after_h);
  leave(to(o), h, after_o);
}

// Removes the half-edge `gone` from a vertex. `other` also starts there, or equals `gone` if it was the last
// one.
void HalfEdges::leave(VertexId v, HalfEdgeId gone, HalfEdgeId other) {
  if (outgoing(v) == gone) set_outgoing(v, other == gone ? HalfEdgeId() : other);
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

// A side of a face that was or is changed leads to it. So do vertices that were or are moved: faces that they
// have in one state alone have sides that changed.
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

}  // namespace kerf
