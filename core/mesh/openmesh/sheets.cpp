#include "core/mesh/openmesh/sheets.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/mesh/weld.h"

namespace kerf {

namespace {

using Kernel = OpenMeshKernel;
constexpr uint32_t kNone = 0xffffffffu;

OpenMesh::Vec3d scaled(const FloatFrame& frame, const Vec3& p) {
  const glm::dvec3 q = frame.scaled(p);
  return {q.x, q.y, q.z};
}

class Copier {
 public:
  Copier(const Mesh& mesh, const Progress* progress)
      : mesh_(mesh), pace_(progress, 2 * size_t{mesh.face_slots()}), handle_(mesh.vertex_slots(), kNone) {}

  Result<Sheets> copy(std::span<const FaceId> kept) {
    add_vertices();
    for (uint32_t f = 0; f < mesh_.face_slots(); ++f) {
      if (!pace_.step()) return cancelled();
      if (mesh_.is_live(FaceId(f))) add_face(FaceId(f));
    }
    for (size_t i = 0; i < out_.faces.size(); ++i) {
      if (!pace_.step()) return cancelled();
      mark_features(i);
    }
    for (const FaceId f : kept) {
      for (const VertexId v : mesh_.corners(f)) lock(vertex_of(v));
    }
    lock_shared_positions();
    return std::move(out_);
  }

 private:
  Kernel::VertexHandle vertex_of(VertexId v) const { return out_.vertex(handle_[v.index]); }
  void lock(Kernel::VertexHandle v) { out_.mesh.status(v).set_locked(true); }

  // The vertices of live faces, in the order of their slots.
  void add_vertices() {
    for (uint32_t f = 0; f < mesh_.face_slots(); ++f) {
      if (!mesh_.is_live(FaceId(f))) continue;
      for (const VertexId v : mesh_.corners(FaceId(f))) handle_[v.index] = 0;
    }
    Vec3 min(0), max(0);
    for (uint32_t v = 0; v < handle_.size(); ++v) {
      if (handle_[v] == kNone) continue;
      handle_[v] = static_cast<uint32_t>(out_.vertices.size());
      const Vec3 p = mesh_.position(VertexId(v));
      min = out_.vertices.empty() ? p : glm::min(min, p);
      max = out_.vertices.empty() ? p : glm::max(max, p);
      out_.vertices.push_back(VertexId(v));
    }
    out_.frame = FloatFrame::around(min, max);
    out_.mesh.reserve(out_.vertices.size(), out_.vertices.size() + mesh_.live_faces(), mesh_.live_faces());
    for (const VertexId v : out_.vertices) out_.mesh.new_vertex(scaled(out_.frame, mesh_.position(v)));
  }

  void add_face(FaceId f) {
    const auto c = mesh_.corners(f);
    std::array<Kernel::VertexHandle, 3> corners{vertex_of(c[0]), vertex_of(c[1]), vertex_of(c[2])};
    Kernel::FaceHandle added;
    if (fits(corners)) added = out_.mesh.add_face(corners[0], corners[1], corners[2]);
    if (!added.is_valid()) {
      for (size_t i = 0; i < 3; ++i) corners[i] = add_own_vertex(c[i]);
      added = out_.mesh.add_face(corners[0], corners[1], corners[2]);
    }
    assert(added.is_valid() && static_cast<size_t>(added.idx()) == out_.faces.size());
    out_.faces.push_back(f);
  }

  // Whether OpenMesh can connect the face; otherwise it would also say so on standard error.
  bool fits(const std::array<Kernel::VertexHandle, 3>& corners) const {
    for (size_t i = 0; i < 3; ++i) {
      if (!out_.mesh.is_boundary(corners[i])) return false;
      const auto h = out_.mesh.find_halfedge(corners[i], corners[(i + 1) % 3]);
      if (h.is_valid() && !out_.mesh.is_boundary(h)) return false;
    }
    return true;
  }

  Kernel::VertexHandle add_own_vertex(VertexId v) {
    const auto own = out_.mesh.new_vertex(scaled(out_.frame, mesh_.position(v)));
    out_.vertices.push_back(v);
    lock(own);
    return own;
  }

  void mark_features(size_t face) {
    const FaceId f = out_.faces[face];
    const auto c = mesh_.corners(f);
    // The half-edges of a face start with the one that ends at its first corner.
    for (const auto h : out_.mesh.fh_range(out_.face(face))) {
      const VertexId from = out_.vertices[static_cast<size_t>(out_.mesh.from_vertex_handle(h).idx())];
      const VertexId to = out_.vertices[static_cast<size_t>(out_.mesh.to_vertex_handle(h).idx())];
      assert(std::find(c.begin(), c.end(), from) != c.end());
      if (!is_feature(f, from, to)) continue;
      out_.mesh.status(out_.mesh.edge_handle(h)).set_feature(true);
      lock(out_.mesh.from_vertex_handle(h));
      lock(out_.mesh.to_vertex_handle(h));
    }
    (void)c;
  }

  bool is_feature(FaceId f, VertexId from, VertexId to) {
    sides_.clear();
    mesh_.append_edge_sides(f, from, to, sides_);
    if (sides_.size() != 1) return true;
    const Mesh::Side& other = sides_.front();
    const bool joined = other.from == to && other.to == from;  // not over a ring
    return !joined || mesh_.data(other.face).material != mesh_.data(f).material;
  }

  void lock_shared_positions() {
    std::vector<Vec3> positions;
    positions.reserve(out_.vertices.size());
    for (const VertexId v : out_.vertices) positions.push_back(mesh_.position(v));
    const std::vector<uint32_t> first = weld_positions(positions);
    out_.shared.assign(positions.size(), false);
    for (uint32_t i = 0; i < first.size(); ++i) {
      if (first[i] == i) continue;
      for (const uint32_t v : {i, first[i]}) {
        out_.shared[v] = true;
        lock(out_.vertex(v));
      }
    }
  }

  const Mesh& mesh_;
  Pace pace_;
  std::vector<uint32_t> handle_;  // by vertex slot
  std::vector<Mesh::Side> sides_;
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

Result<Sheets> to_sheets(const Mesh& mesh, std::span<const FaceId> kept, const Progress* progress) {
  return Copier(mesh, progress).copy(kept);
}

Remeshed from_sheets(const Sheets& sheets, std::span<const FaceId> origin, const Mesh& mesh) {
  assert(origin.size() == sheets.mesh.n_faces());
  std::vector<Vec3> positions;
  positions.reserve(sheets.mesh.n_vertices());
  for (size_t v = 0; v < sheets.mesh.n_vertices(); ++v)
    positions.push_back(position_of(sheets, sheets.vertex(v), mesh));
  const std::vector<uint32_t> first = weld_positions(positions);
  std::vector<uint32_t> order(origin.size());
  std::iota(order.begin(), order.end(), uint32_t{0});
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return origin[a] < origin[b]; });

  Remeshed out;
  std::vector<uint32_t> number(positions.size(), kNone);
  for (const uint32_t f : order) {
    if (sheets.mesh.status(sheets.face(f)).deleted()) continue;
    std::array<uint32_t, 3> corners;
    size_t i = 0;
    for (const auto v : sheets.mesh.fv_range(sheets.face(f)))
      corners[i++] = first[static_cast<size_t>(v.idx())];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (uint32_t& v : corners) {
      if (number[v] == kNone) {
        number[v] = static_cast<uint32_t>(out.positions.size());
        out.positions.push_back(positions[v]);
      }
      v = number[v];
    }
    out.triangles.push_back(corners);
    out.origins.push_back(origin[f]);
  }
  return out;
}

}  // namespace kerf
