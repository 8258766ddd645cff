#include "core/mesh/remesh/openmesh_internal.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

using Kernel = OpenMeshKernel;
OpenMesh::Vec3d scaled(const FloatFrame& frame, const Vec3& p) {
  const glm::dvec3 q = frame.scaled(p);
  return {q.x, q.y, q.z};
}

class Copier {
 public:
  Copier(const Mesh& mesh, FlatSheets flat, const Progress* progress)
      : mesh_(mesh), flat_(std::move(flat)), pace_(progress, 2 * flat_.faces.size()) {
    out_.frame = flat_.frame;
    out_.shared = flat_.shared;
    out_.vertices = flat_.vertices;
    out_.faces = flat_.faces;
  }

  Result<Sheets> copy() {
    add_vertices();
    for (uint32_t f = 0; f < out_.faces.size(); ++f) {
      if (!pace_.step()) return cancelled();
      add_face(f);
    }
    for (uint32_t f = 0; f < out_.faces.size(); ++f) {
      if (!pace_.step()) return cancelled();
      mark_features(f);
    }
    return std::move(out_);
  }

 private:
  static uint32_t next(uint32_t i) { return i == 2 ? 0 : i + 1; }

  void lock(Kernel::VertexHandle v) { out_.mesh.status(v).set_locked(true); }

  void add_vertices() {
    const size_t vertices = out_.vertices.size(), faces = out_.faces.size();
    out_.mesh.reserve(vertices, vertices + faces, faces);
    for (uint32_t v = 0; v < vertices; ++v) {
      const Vec3 p = flat_.point(mesh_, v);
      const auto added = out_.mesh.new_vertex({p.x, p.y, p.z});
      if (flat_.locked[v]) lock(added);
    }
  }

  void add_face(uint32_t f) {
    std::array<Kernel::VertexHandle, 3> corners;
    for (uint32_t i = 0; i < 3; ++i) corners[i] = out_.vertex(flat_.corners[f][i]);
    Kernel::FaceHandle added;
    if (fits(corners)) added = out_.mesh.add_face(corners[0], corners[1], corners[2]);
    if (!added.is_valid()) {
      ++out_.detached;
      for (uint32_t i = 0; i < 3; ++i) corners[i] = add_own_vertex(flat_.corners[f][i]);
      added = out_.mesh.add_face(corners[0], corners[1], corners[2]);
    }
    KERF_ASSERT(added == out_.face(f));
    (void)added;
  }

  // Returns true if OpenMesh can connect the face; otherwise it would report that on standard error.
  bool fits(const std::array<Kernel::VertexHandle, 3>& corners) const {
    for (uint32_t i = 0; i < 3; ++i) {
      if (!out_.mesh.is_boundary(corners[i])) return false;
      const auto h = out_.mesh.find_halfedge(corners[i], corners[next(i)]);
      if (h.is_valid() && !out_.mesh.is_boundary(h)) return false;
    }
    return true;
  }

  // Adds another vertex at the position of `v`, so that both are shared.
  Kernel::VertexHandle add_own_vertex(uint32_t v) {
    const auto own = out_.mesh.new_vertex(out_.mesh.point(out_.vertex(v)));
    out_.vertices.push_back(out_.vertices[v]);
    out_.shared.push_back(true);
    out_.shared[v] = true;
    lock(own);
    lock(out_.vertex(v));
    return own;
  }

  void mark_features(uint32_t f) {
    for (const auto h : out_.mesh.fh_range(out_.face(f))) {
      const VertexId start = out_.vertices[static_cast<size_t>(out_.mesh.from_vertex_handle(h).idx())];
      const std::array<VertexId, 3> c = mesh_.corners(out_.faces[f]);
      if (flat_.feature[3 * f + static_cast<size_t>(std::find(c.begin(), c.end(), start) - c.begin())])
        out_.mesh.status(out_.mesh.edge_handle(h)).set_feature(true);
    }
  }

  const Mesh& mesh_;
  FlatSheets flat_;
  Pace pace_;
  Sheets out_;
};

Vec3 position_of(const Sheets& sheets, Kernel::VertexHandle v, const Mesh& mesh) {
  const auto i = static_cast<size_t>(v.idx());
  const OpenMesh::Vec3d& p = sheets.mesh.point(v);
  if (i < sheets.vertices.size()) {
    const Vec3 original = mesh.position(sheets.vertices[i]);
    if (p == scaled(sheets.frame, original)) return original;
  }
  return sheets.frame.origin + Vec3(p[0], p[1], p[2]) / sheets.frame.scale;
}

}  // namespace

Result<Sheets> to_sheets(const Mesh& mesh, const RemeshLimits& limits, const Progress* progress) {
  ProgressShares shares(progress);
  const Progress copying = shares.next(1 / 3.0), adding = shares.next(2 / 3.0);
  auto flat = to_flat_sheets(mesh, limits, &copying);
  if (!flat) return flat.error();
  return Copier(mesh, std::move(*flat), &adding).copy();
}

Remeshed from_sheets(const Sheets& sheets, std::span<const FaceId> origin, const Mesh& mesh) {
  KERF_ASSERT(origin.size() == sheets.mesh.n_faces());
  std::vector<Vec3> positions;
  positions.reserve(sheets.mesh.n_vertices());
  for (size_t v = 0; v < sheets.mesh.n_vertices(); ++v)
    positions.push_back(position_of(sheets, sheets.vertex(v), mesh));
  WeldedTriangles welded(positions);
  std::vector<uint32_t> order(origin.size());
  std::iota(order.begin(), order.end(), uint32_t{0});
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return origin[a] < origin[b]; });

  Remeshed out;
  for (const uint32_t f : order) {
    if (sheets.mesh.status(sheets.face(f)).deleted()) continue;
    std::array<uint32_t, 3> corners;
    size_t i = 0;
    for (const auto v : sheets.mesh.fv_range(sheets.face(f))) corners[i++] = static_cast<uint32_t>(v.idx());
    if (welded.add(corners)) out.origins.push_back(origin[f]);
  }
  out.positions = std::move(welded.positions);
  out.triangles = std::move(welded.triangles);
  return out;
}

}  // namespace kerf
