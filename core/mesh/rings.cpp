#include "core/mesh/rings.h"

namespace kerf {

namespace {

// Sets one side of the link of the edge of `at`, where `at` and `target` run in one direction.
void set_link(Mesh::Kernel& k, HalfedgeHandle at, HalfedgeHandle RingLink::*side, HalfedgeHandle target) {
  const EdgeHandle edge = k.half_edges.edge_handle(at);
  const bool aligned = at == k.half_edges.halfedge_handle(edge, 0);
  k.rings[static_cast<size_t>(edge.idx())].*side =
      aligned ? target : k.half_edges.opposite_halfedge_handle(target);
}

}  // namespace

HalfedgeHandle next_in_ring(const Mesh::Kernel& k, HalfedgeHandle h) {
  if (k.rings.empty()) return h;
  const EdgeHandle e = k.half_edges.edge_handle(h);
  const HalfedgeHandle next = k.rings[static_cast<size_t>(e.idx())].next;
  return h == k.half_edges.halfedge_handle(e, 0) ? next : k.half_edges.opposite_halfedge_handle(next);
}

HalfedgeHandle previous_in_ring(const Mesh::Kernel& k, HalfedgeHandle h) {
  if (k.rings.empty()) return h;
  const EdgeHandle e = k.half_edges.edge_handle(h);
  const HalfedgeHandle previous = k.rings[static_cast<size_t>(e.idx())].previous;
  return h == k.half_edges.halfedge_handle(e, 0) ? previous : k.half_edges.opposite_halfedge_handle(previous);
}

void leave_ring(Mesh::Kernel& k, EdgeHandle e) {
  if (k.rings.empty()) return;
  const HalfedgeHandle self = k.half_edges.halfedge_handle(e, 0);
  const RingLink link = k.rings[static_cast<size_t>(e.idx())];
  if (link.next == self) return;
  set_link(k, link.previous, &RingLink::next, link.next);
  set_link(k, link.next, &RingLink::previous, link.previous);
  k.rings[static_cast<size_t>(e.idx())] = {self, self};
}

void join_ring(Mesh::Kernel& k, HalfedgeHandle h, HalfedgeHandle member) {
  const HalfedgeHandle after = next_in_ring(k, member);
  set_link(k, h, &RingLink::previous, member);
  set_link(k, h, &RingLink::next, after);
  set_link(k, member, &RingLink::next, h);
  set_link(k, after, &RingLink::previous, h);
}

void add_lone_rings(Mesh::Kernel& k) {
  for (size_t e = k.rings.size(); e < k.half_edges.n_edges(); ++e) {
    const HalfedgeHandle self = k.half_edges.halfedge_handle(EdgeHandle(static_cast<int>(e)), 0);
    k.rings.push_back({self, self});
  }
}

void link_ring(Mesh::Kernel& k, const std::vector<HalfedgeHandle>& members) {
  add_lone_rings(k);
  const HalfEdges& m = k.half_edges;
  for (size_t i = 0; i < members.size(); ++i) {
    const HalfedgeHandle h = members[i];
    HalfedgeHandle next = members[(i + 1) % members.size()];
    HalfedgeHandle previous = members[(i + members.size() - 1) % members.size()];
    const EdgeHandle e = m.edge_handle(h);
    if (h != m.halfedge_handle(e, 0)) {
      next = m.opposite_halfedge_handle(next);
      previous = m.opposite_halfedge_handle(previous);
    }
    k.rings[static_cast<size_t>(e.idx())] = {next, previous};
  }
}

}  // namespace kerf
