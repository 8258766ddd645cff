#include "core/mesh/rings.h"

#include <cassert>

namespace kerf {

namespace {

// Sets one side of the link of the edge of `at`. Precondition: `at` and `target` have the same direction.
void set_link(Mesh::Kernel& k, HalfEdgeId at, HalfEdgeId RingLink::*side, HalfEdgeId target) {
  const EdgeId edge = edge_of(at);
  assert(edge.index < k.rings.size());
  const bool aligned = at == half_edge(edge, 0);
  k.rings.edit(edge.index).*side = aligned ? target : opposite(target);
}

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

void add_lone_rings(Mesh::Kernel& k) {
  for (uint32_t e = k.rings.size(); e < k.half_edges.edges(); ++e) {
    const HalfEdgeId self = half_edge(EdgeId(e), 0);
    k.rings.push_back({self, self});
  }
}

void link_ring(Mesh::Kernel& k, const std::vector<HalfEdgeId>& members) {
  add_lone_rings(k);
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

}  // namespace kerf
