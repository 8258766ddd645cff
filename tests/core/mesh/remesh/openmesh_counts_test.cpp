// OpenMesh as the reference implementation: its circulators agree with Kerf's own structure in meshes that
// were cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "core/base/containers.h"
#include "core/edit/separation.h"
#include "core/mesh/remesh/openmesh_internal.h"
#include "tests/support/features.h"
#include "tests/support/made_meshes.h"
#include "tests/support/real_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

struct Counts {
  std::vector<std::array<size_t, 3>> valences;  // by vertex slot: edges, faces, edges on a boundary
  size_t boundary_loops = 0;
  long euler = 0;
  size_t components = 0;  // over shared edges by position
  size_t glued = 0;       // edges that OpenMesh has once and Kerf twice
};

// Returns true if Kerf has an edge with one face between two vertices of a sheet.
bool is_rim(const Mesh& mesh, VertexId from, VertexId to) {
  Mesh::Star star;
  mesh.star(from, star);
  return std::find(star.rim.begin(), star.rim.end(), to) != star.rim.end();
}

// Returns true if the two faces on an inner edge of OpenMesh are on two edges of Kerf. A ring that ends
// inside a sheet is a slit in it; if the slit is one edge long, its two sides have the same ends, between
// which OpenMesh has only one edge.
bool is_glued(const Sheets& sheets, const Mesh& mesh, OpenMeshKernel::EdgeHandle e) {
  const OpenMeshKernel& m = sheets.mesh;
  const auto h = m.halfedge_handle(e, 0);
  const auto vertex = [&](OpenMeshKernel::VertexHandle v) {
    return sheets.vertices[static_cast<size_t>(v.idx())];
  };
  return is_rim(mesh, vertex(m.from_vertex_handle(h)), vertex(m.to_vertex_handle(h)));
}

// By OpenMesh's circulators. A vertex of Kerf may have several fans, each of which is one vertex here.
Counts circulated(const Sheets& sheets, const Mesh& mesh) {
  Counts n;
  const OpenMeshKernel& m = sheets.mesh;
  n.valences.resize(mesh.vertex_slots());
  for (const auto v : m.vertices()) {
    std::array<size_t, 3>& valence = n.valences[sheets.vertices[static_cast<size_t>(v.idx())].index];
    for (const auto e : m.ve_range(v)) {
      ++valence[0];
      valence[2] += m.is_boundary(e);
    }
    for ([[maybe_unused]] const auto f : m.vf_range(v)) ++valence[1];
  }
  std::vector<bool> seen(m.n_halfedges());
  for (const auto h : m.halfedges()) {
    if (!m.is_boundary(h) || seen[static_cast<size_t>(h.idx())]) continue;
    ++n.boundary_loops;
    for (auto on = h; !seen[static_cast<size_t>(on.idx())]; on = m.next_halfedge_handle(on))
      seen[static_cast<size_t>(on.idx())] = true;
  }
  n.euler =
      static_cast<long>(m.n_vertices()) - static_cast<long>(m.n_edges()) + static_cast<long>(m.n_faces());
  for (const auto e : m.edges()) {
    if (m.is_boundary(e) || !is_glued(sheets, mesh, e)) continue;
    ++n.glued;
    for (const auto v :
         {m.to_vertex_handle(m.halfedge_handle(e, 0)), m.to_vertex_handle(m.halfedge_handle(e, 1))}) {
      n.valences[sheets.vertices[static_cast<size_t>(v.idx())].index][0] += 1;
      n.valences[sheets.vertices[static_cast<size_t>(v.idx())].index][2] += 2;
    }
  }
  UnionFind together(m.n_faces());
  n.components = m.n_faces();
  std::map<std::pair<Place, Place>, uint32_t> face_on;  // at rings
  for (const auto f : m.faces()) {
    const auto own = static_cast<uint32_t>(f.idx());
    for (const auto other : m.ff_range(f))
      n.components -= together.unite(own, static_cast<uint32_t>(other.idx()));
    for (const auto h : m.fh_range(f)) {
      const auto at = [&](OpenMeshKernel::VertexHandle v) {
        return place(mesh.position(sheets.vertices[static_cast<size_t>(v.idx())]));
      };
      const std::pair<Place, Place> ends =
          std::minmax(at(m.from_vertex_handle(h)), at(m.to_vertex_handle(h)));
      n.components -= together.unite(face_on.try_emplace(ends, own).first->second, own);
    }
  }
  return n;
}

// Likewise by the half-edges and rings of Kerf.
class Counter {
 public:
  explicit Counter(const Mesh& mesh) : mesh_(mesh), seen_(3 * size_t{mesh.face_slots()}) {}

  Counts count() {
    n_.valences.resize(mesh_.vertex_slots());
    for (uint32_t f = 0; f < mesh_.face_slots(); ++f) {
      if (!mesh_.is_live(FaceId(f))) continue;
      for (uint32_t i = 0; i < 3; ++i) walk_boundary({f, i});
      for (const VertexId v : mesh_.corners(FaceId(f))) look_at(v);
    }
    // A face has three corners, and an edge two ends: a fan has as many edges as corners, or one more on a
    // rim.
    const size_t edges = (corners_ + rims_ / 2) / 2;
    n_.euler = static_cast<long>(fans_) - static_cast<long>(edges) + static_cast<long>(mesh_.live_faces());
    std::vector<uint32_t> labels;
    n_.components = label_components(mesh_, labels);
    return std::move(n_);
  }

 private:
  struct Side {
    uint32_t face, corner;
    size_t index() const { return 3 * size_t{face} + corner; }
    Side next() const { return {face, (corner + 1) % 3}; }
  };

  void look_at(VertexId v) {
    if (n_.valences[v.index][1] > 0) return;
    Mesh::Star star;
    mesh_.star(v, star);
    const size_t faces = star.faces.size(), rim = star.rim.size();
    n_.valences[v.index] = {faces + rim / 2, faces, rim};
    fans_ += std::max<size_t>(1, rim / 2);
    corners_ += faces;
    rims_ += rim;
  }

  // The opposite side on the same sheet.
  std::optional<Side> beside(Side s) const {
    const auto c = mesh_.corners(FaceId(s.face));
    const VertexId from = c[s.corner], to = c[s.next().corner];
    if (is_rim(mesh_, from, to)) return std::nullopt;
    std::vector<Mesh::Side> sides;
    mesh_.append_edge_sides(FaceId(s.face), from, to, sides);
    for (const Mesh::Side& other : sides) {
      if (other.from != to || other.to != from) continue;
      const auto corners = mesh_.corners(other.face);
      return Side{other.face.index,
                  static_cast<uint32_t>(std::find(corners.begin(), corners.end(), to) - corners.begin())};
    }
    return std::nullopt;
  }

  void walk_boundary(Side start) {
    if (seen_[start.index()] || beside(start)) return;
    ++n_.boundary_loops;
    for (Side on = start; !seen_[on.index()];) {
      seen_[on.index()] = true;
      on = on.next();
      while (const auto other = beside(on)) on = other->next();  // around the fan
    }
  }

  const Mesh& mesh_;
  std::vector<bool> seen_;
  size_t fans_ = 0, corners_ = 0, rims_ = 0;
  Counts n_;
};

void expect_same_counts(const Mesh& mesh, bool chance_allowed = false) {
  const auto sheets = to_sheets(mesh, {}, nullptr);
  ASSERT_TRUE(sheets.ok());
  if (sheets->detached > 0) return;  // OpenMesh cannot represent a sheet that touches itself
  const Counts a = Counter(mesh).count(), b = circulated(*sheets, mesh);
  EXPECT_TRUE(a.valences == b.valences);
  if (b.glued == 0) {  // gluing closes and divides loops
    EXPECT_EQ(a.boundary_loops, b.boundary_loops);
    EXPECT_EQ(a.euler, b.euler);
  }
  // In real meshes an edge may coincide with an unrelated one.
  if (chance_allowed) {
    EXPECT_GE(a.components, b.components);
  } else {
    EXPECT_EQ(a.components, b.components);
  }
}

// Three strokes, with counts after each.
void cut_and_count(World world, uint64_t seed, bool chance_allowed) {
  Random random(seed);
  for (int i = 0; i < 3; ++i) {
    RandomStroke stroke = random_stroke(world, random, 0.03, true);
    if (random.below(2) == 0) stroke.settings.resolution.rim = Rim::kSmooth;
    ASSERT_TRUE(cut_whole(world, stroke.settings, stroke.moves).ok());
    while (!is_settled(world)) continue_separation(world, 100'000);
    if (world.live_faces() == 0) return;
    expect_same_counts(only_body(world).mesh, chance_allowed);
  }
}

TEST(OpenMeshCounts, match_for_every_class_of_mesh_after_random_strokes) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= runs(4); ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      expect_same_counts(build(soup).mesh);
      cut_and_count(world_of(soup), seed, false);
    }
  }
}

TEST(OpenMeshCounts, match_for_random_soups_after_random_strokes) {
  for (uint64_t seed = 1; seed <= runs(30); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    cut_and_count(world_of(random_soup(10 + static_cast<int>(random.below(200)), random)), seed, true);
  }
}

TEST(OpenMeshCounts, match_for_real_meshes_after_random_strokes) {
  const auto files = real_meshes(20'000);
  if (files.empty()) GTEST_SKIP() << kNoRealMeshes;
  for (const auto& file : files) {
    SCOPED_TRACE(file.string() + ", seed 8");
    cut_and_count(world_of_file(file), 8, true);
  }
}

}  // namespace
}  // namespace kerf::test
