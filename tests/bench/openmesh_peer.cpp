#include <malloc.h>

#include <algorithm>
#include <optional>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "tests/bench/kernel_edits.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Kernel = OpenMesh::TriMesh_ArrayKernelT<Traits>;

double allocated() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

Kernel::VertexHandle handle(VertexId v) { return Kernel::VertexHandle(static_cast<int>(v.index)); }

Kernel copy_of(const Mesh& mesh) {
  Kernel kernel;
  for (uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
    const Vec3 p = mesh.position(VertexId(v));
    kernel.add_vertex({p.x, p.y, p.z});
  }
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const auto c = mesh.corners(FaceId(f));
    kernel.add_face(handle(c[0]), handle(c[1]), handle(c[2]));
  }
  return kernel;
}

std::vector<Kernel::EdgeHandle> edges_of(const Kernel& kernel, const KernelEdits& edits) {
  std::vector<Kernel::EdgeHandle> edges;
  for (const auto& edge : edits.splits)
    edges.push_back(kernel.edge_handle(kernel.find_halfedge(handle(edge.from), handle(edge.to))));
  return edges;
}

void split(Kernel& kernel, Kernel::EdgeHandle e) { kernel.split(e, kernel.calc_edge_midpoint(e)); }

}  // namespace

KernelStatistics time_openmesh(const Mesh& mesh, const KernelEdits& edits) {
  KernelStatistics statistics;
  const Kernel whole = copy_of(mesh);
  const std::vector<Kernel::EdgeHandle> edges = edges_of(whole, edits);
  const double before = allocated();
  std::optional<Kernel> kernel(whole);
  statistics.bytes = allocated() - before;
  statistics.split_seconds = seconds_of([&] {
    for (const auto e : edges) split(*kernel, e);
  });
  kernel.emplace(whole);
  for (const auto e : edges)
    statistics.longest_seconds = std::max(statistics.longest_seconds, seconds_of([&] { split(*kernel, e); }));
  kernel.emplace(whole);
  statistics.remove_seconds = seconds_of([&] {
    for (const FaceId f : edits.removals)
      kernel->delete_face(Kernel::FaceHandle(static_cast<int>(f.index)), false);
  });
  return statistics;
}

}  // namespace kerf::bench
