#include "core/walls/wall_mesh_internal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/random.h"
#include "core/walls/chart_region_internal.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

constexpr int64_t kUnit = int64_t{1} << 20, kRing = 64 * kUnit;  // chart units a metre, and around

// A flat wall of so many metres by so many, whose rim has vertices at random distances.
struct FlatWall {
  double length, height;
  std::vector<WallMesh::Vertex> vertices;
  std::vector<ChartVertex> placed;
  std::vector<ChartEdge> edges;

  FlatWall(Random& random, double long_side, double high) : length(long_side), height(high) {
    const Vec2 corners[] = {{0, 0}, {length, 0}, {length, height}, {0, height}};
    for (size_t i = 0; i < 4; ++i) {
      const Vec2 from = corners[i], way = corners[(i + 1) % 4] - from;
      const double whole = std::abs(way.x) + std::abs(way.y);
      for (double at = 0; at < whole - 0.01; at += random.uniform(0.01, 0.1))
        add(from.x + at / whole * way.x, from.y + at / whole * way.y);
    }
    for (uint32_t from = 0; from < placed.size(); ++from) {
      const auto to = static_cast<uint32_t>((from + 1) % placed.size());
      edges.push_back({from, to, placed[to].x - placed[from].x});
    }
  }
  uint32_t add(double x, double y) {
    placed.push_back({static_cast<int64_t>(x * kUnit), static_cast<int64_t>(y * kUnit)});
    vertices.push_back({point(placed.back()), placed.back()});
    return static_cast<uint32_t>(vertices.size() - 1);
  }
  static Vec3 point(const ChartVertex& v) {
    return Vec3(static_cast<double>(v.x), static_cast<double>(v.y), 0) / static_cast<double>(kUnit);
  }
};

double area_of(const WallMesh& wall) {
  double area = 0;
  for (const auto& t : wall.triangles()) {
    const Vec3 a = wall.vertices()[t[0]].at, b = wall.vertices()[t[1]].at, c = wall.vertices()[t[2]].at;
    EXPECT_GT(glm::cross(b - a, c - a).z, 0);
    area += 0.5 * glm::cross(b - a, c - a).z;
  }
  return area;
}

// The ratio of the longest to the shortest side that this share of the triangles does not exceed.
double thinnest_in(const WallMesh& wall, double share = 1) {
  std::vector<double> ratios;
  for (const auto& t : wall.triangles()) {
    std::array<double, 3> sides;
    for (size_t i = 0; i < 3; ++i)
      sides[i] = glm::length(wall.vertices()[t[i]].at - wall.vertices()[t[(i + 1) % 3]].at);
    const auto [least, longest] = std::minmax_element(sides.begin(), sides.end());
    ratios.push_back(*longest / *least);
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios[static_cast<size_t>(share * static_cast<double>(ratios.size() - 1))];
}

std::map<std::pair<uint32_t, uint32_t>, int> sides_of(const WallMesh& wall) {
  std::map<std::pair<uint32_t, uint32_t>, int> sides;
  for (const auto& t : wall.triangles()) {
    for (size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
  }
  return sides;
}

TEST(WallMesh, graded_has_no_long_thin_triangles_and_keeps_its_rim) {
  for (uint64_t seed = 1; seed <= runs(40); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    FlatWall flat(random, random.uniform(0.5, 3), random.uniform(0.3, 30));
    const auto triangles = run_to_completion(ChartRegion(flat.placed, flat.edges, kRing).triangles());
    ASSERT_TRUE(triangles);
    const size_t rim = flat.vertices.size();
    WallMesh wall(
        flat.vertices, *triangles, kRing,
        [](const WallMesh::Vertex&, const WallMesh::Vertex&) { return 0.0; }, 0);
    run_to_completion(wall.improve());
    run_to_completion(wall.grade(0, [](const ChartVertex& v) { return std::optional(FlatWall::point(v)); }));
    EXPECT_NEAR(area_of(wall), flat.length * flat.height, 1e-6 * flat.length * flat.height);
    EXPECT_LE(thinnest_in(wall, 0.99), 16);
    EXPECT_LE(wall.vertices().size(), 4 * rim);
    const auto sides = sides_of(wall);
    for (const auto& [side, times] : sides) {
      EXPECT_EQ(times, 1);
      const bool is_rim = std::any_of(flat.edges.begin(), flat.edges.end(), [&](const ChartEdge& e) {
        return e.from == side.first && e.to == side.second;
      });
      EXPECT_NE(is_rim, sides.contains({side.second, side.first}));
    }
  }
}

// A cylinder of radius 1, along its axis: an edge may span a tenth of a radian.
TEST(WallMesh, graded_along_a_bend_keeps_the_aspect_ratio_below_16) {
  Random random(7);
  FlatWall flat(random, 2, 40);
  const auto on_cylinder = [](const ChartVertex& v) {
    const Vec3 p = FlatWall::point(v);
    return Vec3(std::sin(p.x), p.y, std::cos(p.x));
  };
  for (WallMesh::Vertex& v : flat.vertices) v.at = on_cylinder(v.chart);
  const auto triangles = run_to_completion(ChartRegion(flat.placed, flat.edges, kRing).triangles());
  ASSERT_TRUE(triangles);
  WallMesh wall(
      flat.vertices, *triangles, kRing,
      [](const WallMesh::Vertex& a, const WallMesh::Vertex& b) {
        const double turn = static_cast<double>(std::abs(a.chart.x - b.chart.x)) / static_cast<double>(kUnit);
        return 1 - std::cos(0.5 * turn);
      },
      1 - std::cos(0.05));
  run_to_completion(wall.improve());
  const double before = thinnest_in(wall);
  run_to_completion(wall.grade(0, [&](const ChartVertex& v) { return std::optional(on_cylinder(v)); }));
  EXPECT_GT(before, 200);
  EXPECT_LE(thinnest_in(wall, 0.99), 40);
  EXPECT_LE(wall.vertices().size(), 2 * flat.vertices.size());
}

}  // namespace
}  // namespace kerf
