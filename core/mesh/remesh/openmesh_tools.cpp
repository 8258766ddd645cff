#include "core/mesh/remesh/openmesh_tools.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/mesh/remesh/openmesh_internal.h"
#include "core/mesh/weld.h"

// After the kernel, which clang does not compile otherwise.
#include <OpenMesh/Tools/Smoother/JacobiLaplaceSmootherT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>

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

using Kernel = OpenMeshKernel;

using Point = Kernel::Point;

// Returns cos(2 pi / n) by 30 terms of the power series; the rest is below rounding. Precondition: n >= 2.
double cosine_of_nth_turn(size_t n) {
  constexpr double kTurn = 2 * kPi;
  const double x2 = (kTurn / static_cast<double>(n)) * (kTurn / static_cast<double>(n));
  double term = 1, sum = 1;
  for (int k = 1; k <= 30; ++k) {
    term *= -x2 / static_cast<double>((2 * k - 1) * (2 * k));
    sum += term;
  }
  return sum;
}

// Returns the fraction by which an inner vertex moves towards the mean of its neighbours.
double loop_share(size_t valence) {
  const double t = 3 + 2 * cosine_of_nth_turn(valence);
  return (40 - t * t) / 64;
}
double sqrt3_share(size_t valence) { return (4 - 2 * cosine_of_nth_turn(valence)) / 9; }

// Returns the vertices of the mesh as moved by the scheme, in the order of their handles.
template <typename Share>
std::vector<Point> moved_vertices(const Kernel& mesh, Share share_for) {
  std::vector<double> share(2, 0);
  std::vector<Point> moved;
  moved.reserve(mesh.n_vertices());
  for (const auto v : mesh.vertices()) {
    moved.push_back(mesh.point(v));
    if (mesh.status(v).locked()) continue;
    Point sum(0);
    size_t valence = 0;
    for (const auto other : mesh.vv_range(v)) {
      sum += mesh.point(other);
      ++valence;
    }
    while (share.size() <= valence) share.push_back(share_for(share.size()));
    moved.back() += (sum / static_cast<double>(valence) - mesh.point(v)) * share[valence];
  }
  return moved;
}

// Appends the new vertices of Loop's scheme, in the order of the edges.
void append_edge_points(const Kernel& mesh, std::vector<Point>& points) {
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge_handle(e, 0), o = mesh.halfedge_handle(e, 1);
    const Point ends = mesh.point(mesh.to_vertex_handle(h)) + mesh.point(mesh.to_vertex_handle(o));
    if (mesh.status(e).feature() || mesh.is_boundary(e)) {
      points.push_back(ends * 0.5);
      continue;
    }
    const Point wings = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h))) +
                        mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(o)));
    points.push_back(ends * 0.375 + wings * 0.125);
  }
}

// Appends the new vertices of the sqrt(3) scheme, in the order of the faces.
void append_face_points(const Kernel& mesh, std::vector<Point>& points) {
  for (const auto f : mesh.faces()) {
    Point sum(0);
    for (const auto v : mesh.fv_range(f)) sum += mesh.point(v);
    points.push_back(sum / 3.0);
  }
}

void set_points(Kernel& mesh, const std::vector<Point>& points) {
  KERF_ASSERT(points.size() == mesh.n_vertices());
  for (size_t v = 0; v < points.size(); ++v)
    mesh.set_point(Kernel::VertexHandle(static_cast<int>(v)), points[v]);
}

void split_in_four(Kernel& mesh, bool moving) {
  std::vector<Point> points;
  if (moving) {
    points = moved_vertices(mesh, loop_share);
    append_edge_points(mesh, points);
  }
  OpenMesh::Subdivider::Uniform::LoopT<Kernel> loop;
  loop(mesh, 1, false);  // at the midpoints
  if (moving) set_points(mesh, points);
}

void split_in_three(Kernel& mesh) {
  std::vector<Point> points = moved_vertices(mesh, sqrt3_share);
  append_face_points(mesh, points);
  std::vector<Kernel::EdgeHandle> stay;
  for (const auto e : mesh.edges()) {
    if (mesh.status(e).feature() && !mesh.is_boundary(e)) stay.push_back(e);
  }
  size_t most = 0;
  for (const auto v : mesh.vertices()) most = std::max<size_t>(most, mesh.valence(v));
  OpenMesh::Subdivider::Uniform::Sqrt3T<Kernel> sqrt3;
  sqrt3.init_weights(most + 1);  // OpenMesh accesses the table without a bounds check
  sqrt3(mesh, 1);
  // Features are not flipped: after four flips an edge and both its faces are unchanged.
  for (const auto e : stay) {
    for (int turn = 1; turn < 4; ++turn) mesh.flip(e);
  }
  set_points(mesh, points);
}

// Both subdividers keep a face as one of its parts and append the others, face by face.
std::vector<FaceId> origins_of(const Sheets& sheets, size_t added_a_face) {
  const size_t before = sheets.faces.size();
  KERF_ASSERT(sheets.mesh.n_faces() == (1 + added_a_face) * before);
  std::vector<FaceId> origins = sheets.faces;
  for (size_t f = before; f < sheets.mesh.n_faces(); ++f)
    origins.push_back(sheets.faces[(f - before) / added_a_face]);
  return origins;
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

Result<Remeshed> subdivide(const Mesh& mesh, Subdivision scheme, const RemeshLimits& limits,
                           const Progress* progress) {
  KERF_ASSERT(mesh.live_faces() <= kMaxToSubdivide);
  ProgressShares shares(progress);
  const Progress copying = shares.next(0.4), dividing = shares.next(0.3), back = shares.next(0.3);
  auto sheets = to_sheets(mesh, limits, &copying);
  if (!sheets) return sheets.error();
  if (!dividing.report(0)) return cancelled();
  if (scheme == Subdivision::kSqrt3) {
    split_in_three(sheets->mesh);
  } else {
    split_in_four(sheets->mesh, scheme == Subdivision::kLoop);
  }
  if (!back.report(0)) return cancelled();
  return from_sheets(*sheets, origins_of(*sheets, parts_of_face(scheme) - 1), mesh);
}

Result<Remeshed> smooth(const Mesh& mesh, size_t times, const RemeshLimits& limits,
                        const Progress* progress) {
  ProgressShares shares(progress);
  const Progress copying = shares.next(0.5), moving = shares.next(0.4), back = shares.next(0.1);
  auto sheets = to_sheets(mesh, limits, &copying);
  if (!sheets) return sheets.error();
  {
    // It does not move locked vertices and those on boundaries.
    using Smoother = OpenMesh::Smoother::JacobiLaplaceSmootherT<OpenMeshKernel>;
    Smoother smoother(sheets->mesh);
    smoother.initialize(Smoother::Tangential_and_Normal, Smoother::C0);
    for (size_t i = 0; i < times; ++i) {
      if (!moving.report(static_cast<double>(i) / static_cast<double>(times))) return cancelled();
      smoother.smooth(1);
    }
  }
  if (!back.report(0)) return cancelled();
  return from_sheets(*sheets, sheets->faces, mesh);
}

}  // namespace kerf
