#include "core/mesh/sheet_sides.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/mesh/half_edges_internal.h"

namespace kerf {

void append_sheet_sides_of(const Mesh& mesh, FaceId f, std::vector<SheetSide>& out) {
  KERF_ASSERT(mesh.is_live(f));
  const HalfEdges& m = mesh.kernel().half_edges;
  HalfEdgeId h = m.first(f);
  for (int i = 0; i < 3; ++i, h = m.next(h)) {
    if (m.face(opposite(h)).valid()) continue;
    out.push_back({{f, m.from(h), m.to(h)}, next_in_ring(mesh.kernel(), h) != h});
  }
}

void append_sheet_sides_in(const Mesh& mesh, uint32_t first, uint32_t end, std::vector<SheetSide>& out) {
  const HalfEdges& m = mesh.kernel().half_edges;
  for (uint32_t e = first; e < std::min(end, mesh.edge_slots()); ++e) {
    for (uint32_t side = 0; side < 2; ++side) {
      const HalfEdgeId h = half_edge(EdgeId(e), side);
      if (!m.face(h).valid() || m.face(opposite(h)).valid()) continue;
      out.push_back({{m.face(h), m.from(h), m.to(h)}, next_in_ring(mesh.kernel(), h) != h});
    }
  }
}

void append_sheet_neighbours(const Mesh& mesh, FaceId f, std::vector<FaceId>& out) {
  const HalfEdges& m = mesh.kernel().half_edges;
  HalfEdgeId h = m.first(f);
  for (int i = 0; i < 3; ++i, h = m.next(h)) {
    if (m.face(opposite(h)).valid()) out.push_back(m.face(opposite(h)));
  }
}

}  // namespace kerf
