#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/random.h"
#include "core/mesh/mesh.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/runs.h"

namespace kerf::test {
namespace {

using CornerIds = std::array<VertexId, 3>;

std::vector<Mesh::Side> open_sides(const Mesh& mesh) {
  std::vector<Mesh::Side> sides;
  mesh.append_open_sides(sides);
  return sides;
}

// Every live face by the positions of its corners, the lowest one first.
std::vector<Triangle> sorted_triangles(const Mesh& mesh) {
  const auto less = [](const Vec3& a, const Vec3& b) { return lexicographic_less(a, b); };
  std::vector<Triangle> all;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    Triangle t = mesh.triangle(FaceId(f));
    std::rotate(t.begin(), std::min_element(t.begin(), t.end(), less), t.end());
    all.push_back(t);
  }
  std::sort(all.begin(), all.end(), [&](const Triangle& a, const Triangle& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
  });
  return all;
}

// Returns true if all queries of the meshes are equal to the bit.
void expect_same_mesh(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.face_slots(), b.face_slots());
  ASSERT_EQ(a.vertex_slots(), b.vertex_slots());
  ASSERT_EQ(a.live_faces(), b.live_faces());
  for (uint32_t v = 0; v < a.vertex_slots(); ++v) {
    ASSERT_EQ(a.position(VertexId(v)), b.position(VertexId(v)));
    ASSERT_TRUE(a.colours().get(VertexId(v)).part == b.colours().get(VertexId(v)).part);
  }
  std::vector<FaceId> near_a, near_b;
  Mesh::Star star_a, star_b;
  for (uint32_t i = 0; i < a.face_slots(); ++i) {
    const FaceId f(i);
    ASSERT_EQ(a.is_live(f), b.is_live(f));
    if (!a.is_live(f)) continue;
    ASSERT_EQ(a.corners(f), b.corners(f));
    ASSERT_TRUE(a.data(f).base == b.data(f).base && a.data(f).piece == b.data(f).piece);
    near_a.clear();
    near_b.clear();
    a.append_neighbours(f, near_a);
    b.append_neighbours(f, near_b);
    ASSERT_EQ(near_a, near_b);
    for (const VertexId v : a.corners(f)) {
      a.star(v, star_a);
      b.star(v, star_b);
      ASSERT_TRUE(star_a.faces == star_b.faces && star_a.rim == star_b.rim);
    }
  }
}

// Some connected faces around a random one, or arbitrary faces.
std::vector<FaceId> random_patch(const Mesh& mesh, size_t size, Random& random) {
  std::vector<FaceId> patch;
  std::set<FaceId> taken;
  const bool anywhere = random.below(3) == 0;
  std::vector<FaceId> around{random_live_face(mesh, random)};
  while (patch.size() < size && (anywhere || !around.empty())) {
    FaceId f = random_live_face(mesh, random);
    if (!anywhere) {
      const size_t at = random.below(around.size());
      f = around[at];
      around.erase(around.begin() + static_cast<std::ptrdiff_t>(at));
    }
    if (!taken.insert(f).second) continue;
    patch.push_back(f);
    mesh.append_neighbours(f, around);
  }
  return patch;
}

template <typename T>
void shuffle(std::vector<T>& list, Random& random) {
  for (size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random.below(i)]);
}

Mesh random_closed_mesh(Random& random) {
  const int rings = 4 + static_cast<int>(random.below(8)), sectors = 4 + static_cast<int>(random.below(9));
  switch (random.below(3)) {
    case 0:
      return build(sphere(rings, sectors, 1)).mesh;
    case 1:
      return build(torus(rings, sectors, 1, 0.3)).mesh;
    default:
      return build(both(sphere(rings, sectors, 1), moved(torus(rings, sectors, 1, 0.3), {4, 0, 0}, 1))).mesh;
  }
}

// A face of the patch with its corners rotated, so that any may be the first.
CornerIds turned(CornerIds c, Random& random) {
  std::rotate(c.begin(), c.begin() + random.below(3), c.end());
  return c;
}

TEST(AddFaces, closes_removed_faces_in_any_order_and_undoes_exactly) {
  size_t pinched = 0;
  for (uint64_t seed = 1; seed <= runs(1200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh mesh = random_closed_mesh(random);
    const MeshNumbers numbers = count_numbers(mesh);
    const std::vector<Triangle> triangles = sorted_triangles(mesh);
    const uint32_t vertices = mesh.vertex_slots();
    std::vector<CornerIds> removed;
    for (uint64_t n = 1 + random.below(3); n > 0; --n) {
      for (const FaceId f : random_patch(mesh, 1 + random.below(mesh.live_faces() / 2), random)) {
        removed.push_back(turned(mesh.corners(f), random));
        mesh.remove_face(f);
      }
    }
    std::map<VertexId, int> rims;
    for (const Mesh::Side& s : open_sides(mesh)) ++rims[s.from];
    pinched += std::any_of(rims.begin(), rims.end(), [](const auto& rim) { return rim.second > 1; });
    const Mesh before = mesh;
    shuffle(removed, random);
    Mesh::Change change;
    change.begin(mesh);
    const std::vector<FaceId> added = mesh.add_faces(removed, std::vector<FaceData>(removed.size()));
    change.end(mesh);

    ASSERT_EQ(find_fault(mesh), "");
    ASSERT_TRUE(open_sides(mesh).empty());
    ASSERT_EQ(mesh.vertex_slots(), vertices) << "a vertex was split although its faces are connected";
    expect_same(numbers, count_numbers(mesh));
    EXPECT_EQ(sorted_triangles(mesh), triangles);
    ASSERT_EQ(added.size(), removed.size());
    for (size_t i = 0; i < added.size(); ++i) {
      for (size_t k = 0; k < 3; ++k)
        ASSERT_TRUE(mesh.has_side(added[i], removed[i][k], removed[i][(k + 1) % 3]));
    }
    const Mesh after = mesh;
    change.exchange(mesh);
    ASSERT_NO_FATAL_FAILURE(expect_same_mesh(mesh, before));
    change.exchange(mesh);
    ASSERT_NO_FATAL_FAILURE(expect_same_mesh(mesh, after));
  }
  EXPECT_GT(pinched, runs(1200) / 10) << "vertices at which holes touch";
}

// Removes connected or arbitrary faces, and returns the corners of some of them in random order.
std::vector<CornerIds> remove_patch(Mesh& mesh, Random& random) {
  std::vector<CornerIds> removed;
  for (const FaceId f : random_patch(mesh, 2 + random.below(mesh.live_faces() / 2), random)) {
    removed.push_back(mesh.corners(f));
    mesh.remove_face(f);
  }
  shuffle(removed, random);
  removed.resize(1 + random.below(removed.size()));
  return removed;
}

// Part of the removed faces is added again, in parts. In between each vertex leads to live faces.
TEST(AddFaces, in_slices_gives_the_same_mesh_bit_for_bit) {
  for (uint64_t seed = 1; seed <= runs(400); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh mesh = random_closed_mesh(random);
    const std::vector<CornerIds> removed = remove_patch(mesh, random);
    const uint32_t slots = mesh.vertex_slots();
    Mesh unsliced = mesh;
    unsliced.add_faces(removed, std::vector<FaceData>(removed.size()));

    std::set<VertexId> corners;
    for (const CornerIds& c : removed) corners.insert(c.begin(), c.end());
    const std::vector<VertexId> vertices(corners.begin(), corners.end());
    std::vector<std::array<uint32_t, 3>> faces;
    for (const CornerIds& c : removed) {
      auto& local = faces.emplace_back();
      for (size_t k = 0; k < 3; ++k)
        local[k] = static_cast<uint32_t>(std::distance(corners.begin(), corners.find(c[k])));
    }
    FaceAddition addition(vertices, faces);
    Mesh::Star star;
    while (addition.added() < addition.faces()) {
      const size_t part = 1 + random.below(std::min<size_t>(8, addition.faces() - addition.added()));
      for (const FaceId f : addition.add(mesh, std::vector<FaceData>(part))) {
        for (const VertexId v : mesh.corners(f)) {
          mesh.star(v, star);
          ASSERT_FALSE(star.faces.empty());
          for (const FaceId beside : star.faces) ASSERT_TRUE(mesh.is_live(beside));
        }
      }
    }
    std::vector<FaceId> changed;
    while (!addition.split_fans(mesh, 1 + random.below(5), changed)) {
    }
    ASSERT_NO_FATAL_FAILURE(expect_same_mesh(mesh, unsliced));
    ASSERT_EQ(find_fault(mesh), "");
    for (const FaceId f : changed) ASSERT_TRUE(mesh.is_live(f));
    EXPECT_EQ(changed.empty(), mesh.vertex_slots() == slots);
  }
}

// Part of the removed faces is added again, the rest stays open. Faces around a vertex that are not connected
// over edges have a vertex each; only vertices of the added faces may split.
TEST(AddFaces, splits_vertices_whose_faces_are_not_connected) {
  size_t parted = 0;
  for (uint64_t seed = 1; seed <= runs(1200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh mesh = random_closed_mesh(random);
    const std::vector<CornerIds> removed = remove_patch(mesh, random);
    const uint32_t vertices = mesh.vertex_slots();
    std::set<VertexId> touched;
    for (const CornerIds& c : removed) touched.insert(c.begin(), c.end());
    mesh.add_faces(removed, std::vector<FaceData>(removed.size()));
    ASSERT_EQ(find_fault(mesh), "");
    parted += mesh.vertex_slots() > vertices;

    std::map<VertexId, std::set<FaceId>> around;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (!mesh.is_live(FaceId(f))) continue;
      for (const VertexId v : mesh.corners(FaceId(f))) around[v].insert(FaceId(f));
    }
    Mesh::Star star;
    for (const auto& [v, faces] : around) {
      mesh.star(v, star);
      ASSERT_EQ(std::set<FaceId>(star.faces.begin(), star.faces.end()), faces);
      if (!touched.contains(v) && v.index < vertices) continue;
      std::set<FaceId> reached{*faces.begin()};  // over edges at the vertex
      std::vector<FaceId> waiting{*faces.begin()}, near;
      while (!waiting.empty()) {
        near.clear();
        mesh.append_neighbours(waiting.back(), near);
        waiting.pop_back();
        for (const FaceId n : near) {
          if (faces.contains(n) && reached.insert(n).second) waiting.push_back(n);
        }
      }
      ASSERT_EQ(reached, faces) << "around vertex " << v.index;
    }
  }
  EXPECT_GT(parted, runs(1200) / 10);
}

TEST(AddFaces, closes_each_hole_with_a_fan_around_a_new_vertex) {
  size_t closed = 0;
  for (uint64_t seed = 1; seed <= runs(600); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh mesh = random_closed_mesh(random);
    for (const FaceId f : random_patch(mesh, 1 + random.below(12), random)) mesh.remove_face(f);
    std::map<VertexId, VertexId> next;
    const std::vector<Mesh::Side> open = open_sides(mesh);
    for (const Mesh::Side& s : open) next[s.from] = s.to;
    if (next.size() < open.size() || open.empty()) continue;  // holes touch in a vertex
    std::vector<CornerIds> cones;
    for (std::set<VertexId> done; done.size() < next.size();) {
      VertexId v = std::find_if(next.begin(), next.end(), [&](const auto& n) {
                     return !done.contains(n.first);
                   })->first;
      const VertexId apex =
          mesh.add_vertex(Vec3(random.uniform(2, 3), 2, 0.1 * static_cast<double>(done.size())));
      for (; done.insert(v).second; v = next[v]) cones.push_back({next[v], v, apex});
    }
    shuffle(cones, random);
    const uint32_t vertices = mesh.vertex_slots();
    mesh.add_faces(cones, std::vector<FaceData>(cones.size()));
    ASSERT_EQ(find_fault(mesh), "");
    ASSERT_TRUE(open_sides(mesh).empty());
    ASSERT_EQ(mesh.vertex_slots(), vertices);
    ++closed;
  }
  EXPECT_GT(closed, runs(600) / 4);
}

TEST(AddFaces, sets_the_data_of_added_faces_only) {
  Mesh mesh = build(sphere(6, 8, 1)).mesh;
  const FaceColumn<uint32_t> tag = mesh.columns().attach_copied<uint32_t>();
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) mesh.columns().set(tag, FaceId(f), f + 1);
  const uint32_t slots = mesh.face_slots();
  std::vector<CornerIds> removed;
  std::vector<FaceData> data;
  for (uint32_t f = 0; f < 10; ++f) {
    removed.push_back(mesh.corners(FaceId(f)));
    mesh.remove_face(FaceId(f));
    data.emplace_back();
    data.back().piece = f;
    data.back().material = static_cast<uint16_t>(2 * f);
  }
  const std::vector<FaceId> added = mesh.add_faces(removed, data);
  ASSERT_EQ(mesh.live_faces(), slots);
  for (uint32_t i = 0; i < added.size(); ++i) {
    EXPECT_EQ(added[i], FaceId(slots + i));
    EXPECT_EQ(mesh.data(added[i]).base, added[i]);
    EXPECT_EQ(mesh.data(added[i]).piece, i);
    EXPECT_EQ(mesh.data(added[i]).material, 2 * i);
    EXPECT_EQ(mesh.columns().get(tag, added[i]), 0u);
  }
  EXPECT_EQ(mesh.columns().get(tag, FaceId(10)), 11u);
}

// Three sheets that share an edge elsewhere stay linked, and take part in later splits.
TEST(AddFaces, keeps_edges_splittable) {
  for (uint64_t seed = 1; seed <= runs(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Soup ring = moved(book(3), {9, 0, 0}, 1);
    Mesh mesh = build(random.below(2) == 0 ? both(sphere(6, 8, 1), ring) : sphere(6, 8, 1)).mesh;
    std::vector<CornerIds> removed;
    for (uint32_t f = 0; f < 20; ++f) {
      removed.push_back(mesh.corners(FaceId(f)));
      mesh.remove_face(FaceId(f));
    }
    shuffle(removed, random);
    mesh.add_faces(removed, std::vector<FaceData>(removed.size()));
    const MeshNumbers numbers = count_numbers(mesh);
    std::vector<Mesh::FaceSplit> splits;
    for (int i = 0; i < 60; ++i) {
      const FaceId f = random_live_face(mesh, random);
      const CornerIds c = turned(mesh.corners(f), random);
      mesh.split_edge(f, c[0], c[1], splits);
    }
    ASSERT_EQ(find_fault(mesh), "");
    expect_same(numbers, count_numbers(mesh));
  }
}

TEST(SheetSides, have_no_face_across_on_their_sheet) {
  for (const auto& [name, soup] : mesh_classes()) {
    SCOPED_TRACE(name);
    const Mesh mesh = build(soup).mesh;
    size_t sides = 0;
    for (uint32_t slot = 0; slot < mesh.face_slots(); ++slot) {
      const FaceId f(slot);
      std::vector<SheetSide> own;
      std::vector<FaceId> neighbours, expected;
      append_sheet_sides_of(mesh, f, own);
      append_sheet_neighbours(mesh, f, neighbours);
      size_t i = 0;
      for (const SheetEdge& edge : sheet_edges_of(mesh, f)) {
        if (edge.across.valid()) {
          expected.push_back(edge.across);
          continue;
        }
        ASSERT_LT(i, own.size());
        EXPECT_TRUE(own[i].side.face == f && own[i].side.from == edge.from && own[i].side.to == edge.to &&
                    own[i].is_shared == edge.is_shared);
        ++i;
      }
      EXPECT_EQ(i, own.size());
      EXPECT_EQ(neighbours, expected);
      sides += i;
    }
    std::vector<SheetSide> all;
    append_sheet_sides_in(mesh, 0, mesh.edge_slots() + 3, all);
    EXPECT_EQ(all.size(), sides);
  }
}

TEST(ExtractMesh, keeps_the_rings_of_sheets_with_a_common_edge) {
  const Soup ball = sphere(4, 6, 1);
  const Mesh mesh = build(both(ball, moved(book(5), {9, 0, 0}, 1))).mesh;
  const auto first = static_cast<uint32_t>(ball.triangles.size());
  std::vector<FaceId> faces;
  for (uint32_t f = first; f < mesh.face_slots(); ++f) faces.emplace_back(f);
  const Mesh copy = extract_mesh(mesh, faces);
  EXPECT_EQ(find_fault(copy), "");
  for (uint32_t i = 0; i < faces.size(); ++i) {
    std::vector<FaceId> neighbours, expected;
    copy.append_neighbours(FaceId(i), neighbours);
    mesh.append_neighbours(faces[i], expected);
    for (FaceId& f : expected) f = FaceId(f.index - first);
    std::sort(neighbours.begin(), neighbours.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(neighbours, expected);
  }
}

}  // namespace
}  // namespace kerf::test
