#include "core/mesh/mesh_bounds.h"

#include <vector>

#include "core/base/parallel.h"
#include "core/mesh/kernel.h"

namespace kerf {

Result<Bounds> bounds_of(const Mesh& mesh, const Progress* progress) {
  constexpr size_t kVertices = 1 << 16;  // a range
  const HalfEdges& m = mesh.kernel().half_edges;
  std::vector<Bounds> parts(range_count(m.vertices(), kVertices), Bounds::none());
  const auto bound = [&](size_t first, size_t end) {
    Bounds& bounds = parts[first / kVertices];
    for (auto v = static_cast<uint32_t>(first); v < end; ++v) {
      // A vertex has an edge as long as it has a face.
      if (m.outgoing(VertexId(v)).valid()) bounds.add(m.position(VertexId(v)));
    }
  };
  if (!for_each_range(m.vertices(), kVertices, progress, bound)) return cancelled();
  Bounds all = Bounds::none();
  for (const Bounds& part : parts) all.add(part);
  return all;
}

}  // namespace kerf
