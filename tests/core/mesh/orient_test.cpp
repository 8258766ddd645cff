#include "core/mesh/orientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_file.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/real_meshes.h"

namespace kerf::test {
namespace {

Soup turned(Soup soup) {
  for (auto& t : soup.triangles) std::swap(t[0], t[1]);
  return soup;
}

// The signed volume of the faces first .. last - 1, relative to one of their corners.
double volume(const Mesh& mesh, uint32_t first, uint32_t last) {
  const Vec3 apex = mesh.triangle(FaceId(first))[0];
  double sum = 0;
  for (uint32_t f = first; f < last; ++f) {
    const auto [a, b, c] = mesh.triangle(FaceId(f));
    sum += glm::dot(a - apex, glm::cross(b - apex, c - apex)) / 6;
  }
  return sum;
}

double volume(const Soup& soup) {
  const Mesh mesh = build(soup).mesh;
  return volume(mesh, 0, mesh.face_slots());
}

// A prism over an L; its bounding box contains more than the prism.
Soup angle() {
  const std::vector<Vec2> outline = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  Soup soup = plate(1);
  soup.positions.clear();
  for (const double z : {0.0, 2.0}) {
    for (const Vec2& p : outline) soup.positions.push_back({p.x, p.y, z});
  }
  soup.triangles = {{6, 7, 8}, {6, 8, 9}, {6, 9, 11}, {9, 10, 11},
                    {0, 2, 1}, {0, 3, 2}, {0, 5, 3},  {3, 5, 4}};
  for (uint32_t i = 0; i < 6; ++i) {
    const uint32_t next = (i + 1) % 6;
    soup.triangles.push_back({i, next, next + 6});
    soup.triangles.push_back({i, next + 6, i + 6});
  }
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  return soup;
}

// The patches of a soup that overlap with others.
std::vector<uint32_t> overlapping(const Soup& soup) {
  const Mesh mesh = build(soup).mesh;
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    std::array<uint32_t, 3> corners{};
    for (size_t i = 0; i < 3; ++i) corners[i] = mesh.corners(FaceId(f))[i].index;
    triangles.push_back(corners);
  }
  for (uint32_t v = 0; v < mesh.vertex_slots(); ++v) positions.push_back(mesh.position(VertexId(v)));
  const auto patches = find_patches(triangles, group_sides(triangles, positions.size()), nullptr);
  return overlapping_patches(positions, triangles, *patches);
}

TEST(OverlappingPatches, do_not_alternate_between_outward_and_inward) {
  using Found = std::vector<uint32_t>;
  const Soup ball = sphere(8, 12, 1), inner = moved(ball, {0.1, 0.05, 0}, 0.7),
             marble = moved(ball, {0.12, 0.04, 0}, 0.3);
  EXPECT_EQ(overlapping(both(ball, inner)), Found{1});
  EXPECT_EQ(overlapping(both(inner, ball)), Found{0});
  EXPECT_EQ(overlapping(both(ball, turned(inner))), Found{});
  EXPECT_EQ(overlapping(both(ball, both(turned(inner), marble))), Found{});
  EXPECT_EQ(overlapping(both(ball, both(turned(inner), turned(marble)))), Found{2});
  EXPECT_EQ(overlapping(both(ball, both(inner, marble))), Found{1});
  EXPECT_EQ(overlapping(both(ball, moved(ball, {2.2, 0, 0}, 0.5))), Found{}) << "side by side";
  EXPECT_EQ(overlapping(both(ball, moved(grid(2, 0.5), {0.1, 0.05, 0}, 1))), Found{}) << "not closed";
}

Soup random_closed(Random& random) {
  const int rings = 3 + static_cast<int>(random.below(5)), sectors = 3 + static_cast<int>(random.below(6));
  return random.below(2) == 0 ? sphere(rings, sectors, 0.4) : torus(rings, sectors, 0.3, 0.1);
}

// Closed parts next to each other, some with a smaller one inside; a random subset faces inward.
struct Scene {
  Soup soup;
  struct Part {
    uint32_t first, last;  // its triangles
    bool turned, is_cavity;
  };
  std::vector<Part> parts;

  void add(const Soup& part, bool turn, bool is_cavity) {
    const auto first = static_cast<uint32_t>(soup.triangles.size());
    soup = both(soup, turn ? turned(part) : part);
    parts.push_back({first, static_cast<uint32_t>(soup.triangles.size()), turn, is_cavity});
  }
};

Scene random_scene(Random& random) {
  Scene scene;
  const double scale = random.uniform(0.001, 1000);
  const Vec3 middle =
      1000 * scale * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  for (uint64_t i = 0, n = 1 + random.below(20); i < n; ++i) {
    const Vec3 at(static_cast<double>(i % 3), static_cast<double>(i / 3 % 3), static_cast<double>(i / 9));
    const Vec3 place = middle + scale * at;
    if (random.below(3) > 0) {
      scene.add(moved(random_closed(random), place, scale), random.below(2) == 0, false);
    } else {
      scene.add(moved(sphere(8, 10, 0.4), place, scale), random.below(2) == 0, false);
      scene.add(moved(random_closed(random), place, 0.5 * scale), random.below(2) == 0, true);
    }
  }
  return scene;
}

using Corners = std::array<double, 9>;

// The faces of a mesh, each from its lowest corner on, sorted.
std::vector<Corners> oriented_faces(const Mesh& mesh) {
  std::vector<Corners> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const Triangle t = mesh.triangle(FaceId(f));
    std::array<Corners, 3> from;
    for (size_t i = 0; i < 3; ++i) {
      for (size_t j = 0; j < 9; ++j) from[i][j] = t[(i + j / 3) % 3][static_cast<int>(j % 3)];
    }
    faces.push_back(*std::min_element(from.begin(), from.end()));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

TEST(Orient, turns_closed_parts_outward_and_keeps_possible_cavities) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Scene scene = random_scene(random);
    const BuiltMesh built = build(scene.soup);
    size_t expected = 0;
    for (const Scene::Part& part : scene.parts) {
      EXPECT_EQ(volume(built.mesh, part.first, part.last) > 0, !(part.is_cavity && part.turned));
      if (part.turned && !part.is_cavity) expected += part.last - part.first;
    }
    EXPECT_EQ(built.report.repairs.reoriented_faces, expected);
    EXPECT_EQ(find_fault(built.mesh), "");
  }
}

TEST(Orient, turns_closed_parts_of_any_size_outward) {
  for (const int exponent : {-400, 0, 400}) {
    const Soup soup = moved(turned(sphere(6, 8, 1)), Vec3(0), std::ldexp(1.0, exponent));
    EXPECT_EQ(build(soup).report.repairs.reoriented_faces, soup.triangles.size()) << exponent;
  }
}

TEST(Orient, does_not_depend_on_the_order_of_faces) {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Soup soup = random_scene(random).soup;
    const std::vector<Corners> faces = oriented_faces(build(soup).mesh);
    for (size_t i = soup.triangles.size(); i > 1; --i)
      std::swap(soup.triangles[i - 1], soup.triangles[random.below(i)]);
    EXPECT_EQ(oriented_faces(build(soup).mesh), faces);
  }
}

TEST(Orient, turns_a_part_inside_the_bounding_box_but_outside_the_solid) {
  EXPECT_GT(volume(angle()), 0);
  const Soup beside = moved(sphere(6, 8, 0.5), {2.5, 2.5, 1}, 1),
             inside = moved(sphere(6, 8, 0.3), {2.5, 0.5, 1}, 1);
  const auto sphere_of = [](const Soup& part) {
    const Mesh mesh = build(both(angle(), turned(part))).mesh;
    return volume(mesh, static_cast<uint32_t>(angle().triangles.size()), mesh.face_slots());
  };
  EXPECT_GT(sphere_of(beside), 0);
  EXPECT_LT(sphere_of(inside), 0);
}

TEST(Orient, turns_parts_that_share_an_edge_outward) {
  Soup wedge = plate(1);
  wedge.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0.5, 1, 0}};
  wedge.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}};
  Soup mirrored = turned(wedge);
  for (Vec3& p : mirrored.positions) p.x = -p.x;
  for (const Soup& first : {wedge, turned(wedge)}) {
    for (const Soup& second : {mirrored, turned(mirrored)}) {
      const BuiltMesh built = build(both(first, second));
      EXPECT_EQ(built.report.non_manifold_edges, 1u);
      EXPECT_GT(volume(built.mesh, 0, 4), 0);
      EXPECT_GT(volume(built.mesh, 4, 8), 0);
    }
  }
}

TEST(Orient, leaves_open_and_flat_parts_unchanged) {
  Soup flat = plate(1);
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
  flat.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};  // a tetrahedron without volume
  flat.faces_in_file = flat.triangles_in_file = 4;
  for (const Soup& soup : {grid(3, 1), tube(3, 8, 0.4, 1), flat, moved(flat, {1e6, -1e6, 1e6}, 1)}) {
    EXPECT_EQ(build(soup).report.repairs.reoriented_faces, 0u);
    EXPECT_EQ(build(turned(soup)).report.repairs.reoriented_faces, 0u);
  }
}

TEST(Orient, turns_a_real_inside_out_part_outward) {
  const auto files = real_meshes(3000);
  const auto file =
      std::find_if(files.begin(), files.end(), [](const auto& f) { return f.filename() == "boeing.off"; });
  if (file == files.end()) GTEST_SKIP() << kNoRealMeshes;
  const auto built = load_mesh(*file, nullptr);
  ASSERT_TRUE(built.ok());
  EXPECT_EQ(built->report.repairs.reoriented_faces, built->report.faces - 1132);
  EXPECT_GT(volume(built->mesh, 0, built->mesh.face_slots()), 0);
}

}  // namespace
}  // namespace kerf::test
