#include "core/mesh/openmesh/sheets.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/union_find.h"
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
  Copier(const Mesh& mesh, const Progress* progress)
      : mesh_(mesh), pace_(progress, 3 * size_t{mesh.live_faces()}), fans_(3 * size_t{mesh.live_faces()}) {}

  Result<Sheets> copy(std::span<const FaceId> kept) {
    number_faces();
    for (uint32_t f = 0; f < out_.faces.size(); ++f) {
      if (!pace_.step()) return cancelled();
      for (uint32_t i = 0; i < 3; ++i) look_at_side(f, i);
    }
    add_vertices();
    for (uint32_t f = 0; f < out_.faces.size(); ++f) {
      if (!pace_.step()) return cancelled();
      add_face(f);
    }
    for (uint32_t f = 0; f < out_.faces.size(); ++f) {
      if (!pace_.step()) return cancelled();
      mark_features(f);
    }
    for (const FaceId f : kept) {
      for (const auto v : out_.mesh.fv_range(out_.face(number_[f.index]))) lock(v);
    }
    lock_shared_positions();
    return std::move(out_);
  }

 private:
  // Side 3 f + i of face number f runs from corner i to the next one.
  static uint32_t next(uint32_t i) { return i == 2 ? 0 : i + 1; }

  void lock(Kernel::VertexHandle v) { out_.mesh.status(v).set_locked(true); }

  void number_faces() {
    number_.assign(mesh_.face_slots(), kNoIndex);
    for (uint32_t f = 0; f < mesh_.face_slots(); ++f) {
      if (!mesh_.is_live(FaceId(f))) continue;
      number_[f] = static_cast<uint32_t>(out_.faces.size());
      out_.faces.emplace_back(f);
      corners_.push_back(mesh_.corners(FaceId(f)));
    }
    feature_.assign(3 * out_.faces.size(), false);
  }

  // Joins the fans at both ends with those of the face on the other side, if there is one on the same sheet.
  void look_at_side(uint32_t f, uint32_t i) {
    const VertexId from = corners_[f][i], to = corners_[f][next(i)];
    sides_.clear();
    mesh_.append_edge_sides(out_.faces[f], from, to, sides_);
    const auto beside = std::find_if(sides_.begin(), sides_.end(),
                                     [&](const Mesh::Side& s) { return s.from == to && s.to == from; });
    feature_[3 * size_t{f} + i] = sides_.size() != 1 || beside == sides_.end() ||
                                  mesh_.data(beside->face).material != mesh_.data(out_.faces[f]).material;
    if (beside == sides_.end()) return;
    const uint32_t other = number_[beside->face.index];
    const auto& c = corners_[other];
    const auto at = [&](VertexId v) {
      return 3 * other + static_cast<uint32_t>(std::find(c.begin(), c.end(), v) - c.begin());
    };
    fans_.unite(3 * f + i, at(from));
    fans_.unite(3 * f + next(i), at(to));
  }

  // Adds one vertex for each fan, in the order of the slots of vertices and, at one vertex, of the faces.
  void add_vertices() {
    std::vector<std::pair<VertexId, uint32_t>> fans;  // with the first corner
    for (uint32_t f = 0; f < out_.faces.size(); ++f) {
      for (uint32_t i = 0; i < 3; ++i) {
        if (fans_.find(3 * f + i) == 3 * f + i) fans.emplace_back(corners_[f][i], 3 * f + i);
      }
    }
    std::sort(fans.begin(), fans.end());
    Vec3 min = fans.empty() ? Vec3(0) : mesh_.position(fans[0].first), max = min;
    vertex_of_.resize(3 * out_.faces.size());
    for (const auto& [v, corner] : fans) {
      vertex_of_[corner] = static_cast<uint32_t>(out_.vertices.size());
      out_.vertices.push_back(v);
      min = glm::min(min, mesh_.position(v));
      max = glm::max(max, mesh_.position(v));
    }
    out_.frame = FloatFrame::around(min, max);
    out_.mesh.reserve(fans.size(), fans.size() + out_.faces.size(), out_.faces.size());
    for (const VertexId v : out_.vertices) out_.mesh.new_vertex(scaled(out_.frame, mesh_.position(v)));
  }

  void add_face(uint32_t f) {
    std::array<Kernel::VertexHandle, 3> corners;
    for (uint32_t i = 0; i < 3; ++i) corners[i] = out_.vertex(vertex_of_[fans_.find(3 * f + i)]);
    Kernel::FaceHandle added;
    if (fits(corners)) added = out_.mesh.add_face(corners[0], corners[1], corners[2]);
    if (!added.is_valid()) {
      ++out_.detached;
      for (uint32_t i = 0; i < 3; ++i) corners[i] = add_own_vertex(corners_[f][i]);
      added = out_.mesh.add_face(corners[0], corners[1], corners[2]);
    }
    KERF_ASSERT(added == out_.face(f));
    (void)added;
  }

  // Whether OpenMesh can connect the face; otherwise it would also say so on standard error.
  bool fits(const std::array<Kernel::VertexHandle, 3>& corners) const {
    for (uint32_t i = 0; i < 3; ++i) {
      if (!out_.mesh.is_boundary(corners[i])) return false;
      const auto h = out_.mesh.find_halfedge(corners[i], corners[next(i)]);
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

  void mark_features(uint32_t f) {
    for (const auto h : out_.mesh.fh_range(out_.face(f))) {
      const auto from = out_.mesh.from_vertex_handle(h), to = out_.mesh.to_vertex_handle(h);
      const VertexId start = out_.vertices[static_cast<size_t>(from.idx())];
      const auto& c = corners_[f];
      if (!feature_[3 * f + static_cast<size_t>(std::find(c.begin(), c.end(), start) - c.begin())]) continue;
      out_.mesh.status(out_.mesh.edge_handle(h)).set_feature(true);
      lock(from);
      lock(to);
    }
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
  UnionFind fans_;                                // of corners
  std::vector<uint32_t> number_;                  // by face slot
  std::vector<std::array<VertexId, 3>> corners_;  // by face number
  std::vector<bool> feature_;                     // by side
  std::vector<uint32_t> vertex_of_;               // by the first corner of a fan
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
  KERF_ASSERT(origin.size() == sheets.mesh.n_faces());
  std::vector<Vec3> positions;
  positions.reserve(sheets.mesh.n_vertices());
  for (size_t v = 0; v < sheets.mesh.n_vertices(); ++v)
    positions.push_back(position_of(sheets, sheets.vertex(v), mesh));
  const std::vector<uint32_t> first = weld_positions(positions);
  std::vector<uint32_t> order(origin.size());
  std::iota(order.begin(), order.end(), uint32_t{0});
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return origin[a] < origin[b]; });

  Remeshed out;
  std::vector<uint32_t> number(positions.size(), kNoIndex);
  for (const uint32_t f : order) {
    if (sheets.mesh.status(sheets.face(f)).deleted()) continue;
    std::array<uint32_t, 3> corners;
    size_t i = 0;
    for (const auto v : sheets.mesh.fv_range(sheets.face(f)))
      corners[i++] = first[static_cast<size_t>(v.idx())];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (uint32_t& v : corners) {
      if (number[v] == kNoIndex) {
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
