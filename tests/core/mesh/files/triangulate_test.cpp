#include "core/mesh/files/triangulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/base/random.h"

namespace kerf {
namespace {

using Polygon = std::vector<Vec3>;

std::vector<Soup::Triangle> triangulate(const Polygon& polygon) {
  std::vector<uint32_t> corners(polygon.size());
  std::iota(corners.begin(), corners.end(), 0u);
  std::vector<Soup::Triangle> triangles;
  Triangulator().append(polygon, corners, triangles);
  return triangles;
}

Vec3 area_vector(const Polygon& p, uint32_t a, uint32_t b, uint32_t c) {
  return 0.5 * glm::cross(p[b] - p[a], p[c] - p[a]);
}

// Exactly n - 2 triangles, none flipped, which add up to the polygon's area.
void expect_covered(const Polygon& polygon, const std::string& name) {
  const auto triangles = triangulate(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2) << name;
  Vec3 whole(0);
  for (uint32_t i = 1; i + 1 < polygon.size(); ++i) whole += area_vector(polygon, 0, i, i + 1);
  const double expected = glm::length(whole);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 area = area_vector(polygon, a, b, c);
    sum += glm::length(area);
    EXPECT_GE(glm::dot(area, whole), -1e-12 * expected * expected) << name << ": a triangle is turned over";
  }
  EXPECT_NEAR(sum, expected, 1e-9 * expected) << name;
}

Polygon star(size_t corners, auto radius) {
  Polygon polygon;
  for (size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    const double r = radius(i);
    polygon.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return polygon;
}

// A staircase of two parallel lines of steps.
Polygon stairs(int steps) {
  Polygon polygon;
  for (int i = 0; i < steps; ++i) polygon.insert(polygon.end(), {Vec3(i, i, 0), Vec3(i + 1, i, 0)});
  for (int i = steps; i-- > 0;) polygon.insert(polygon.end(), {Vec3(i + 1, i + 1.5, 0), Vec3(i, i + 1.5, 0)});
  return polygon;
}

// A square with square holes in a row, each joined to the previous one by a seam.
Polygon square_with_holes(int holes) {
  const double width = 4.0 * holes + 2;
  Polygon polygon{{0, 0, 0}, {width, 0, 0}, {width, 4, 0}, {0, 4, 0}};
  Polygon back;
  for (int i = 0; i < holes; ++i) {
    const double x = 4.0 * i + 1;
    polygon.insert(polygon.end(), {i == 0 ? Vec3(0, 0, 0) : Vec3(x - 1.5, 2, 0), Vec3(x, 1, 0), Vec3(x, 3, 0),
                                   Vec3(x + 2, 3, 0)});
    const Polygon under{
        {x + 2, 3, 0}, {x + 2, 1, 0}, {x, 1, 0}, i == 0 ? Vec3(0, 0, 0) : Vec3(x - 1.5, 2, 0)};
    if (i + 1 == holes) {
      polygon.insert(polygon.end(), under.begin() + 1, under.end());
    } else {
      polygon.push_back(Vec3(x + 2.5, 2, 0));
      back.insert(back.begin(), under.begin(), under.end());
    }
  }
  polygon.insert(polygon.end(), back.begin(), back.end());
  polygon.pop_back();
  return polygon;
}

Polygon moved(Polygon polygon, const Vec3& u, const Vec3& v, const Vec3& offset) {
  for (Vec3& p : polygon) p = p.x * u + p.y * v + offset;
  return polygon;
}

TEST(Triangulate, cuts_quads_along_an_inner_diagonal) {
  const Polygon dart{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
  for (size_t turn = 0; turn < 4; ++turn) {
    Polygon turned = dart;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turn), turned.end());
    expect_covered(turned, "dart turned " + std::to_string(turn));
  }
  EXPECT_EQ(triangulate({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
            (std::vector<Soup::Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulate, covers_concave_polygons_in_any_plane) {
  Random random(3);
  const Polygon corner{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  for (const auto& [u, v] : {std::pair(Vec3(1, 0, 0), Vec3(0, 1, 0)),
                             {Vec3(0, 1, 0), Vec3(0, 0, 1)},
                             {Vec3(0, 0, 1), Vec3(1, 0, 0)},
                             {Vec3(0, 1, 0), Vec3(1, 0, 0)},
                             {Vec3(1, 2, 3), Vec3(-3, 0, 1)}}) {
    expect_covered(moved(corner, u, v, {5, -7, 9}), "corner");
    expect_covered(moved(star(101, [&](size_t) { return random.uniform(0.1, 1); }), u, v, {1, 2, 3}), "star");
  }
}

TEST(Triangulate, creates_no_flat_triangles_at_collinear_corners) {
  Polygon polygon;
  for (int i = 0; i < 10; ++i) polygon.push_back({i, 0, 0});
  for (int i = 0; i < 10; ++i) polygon.push_back({10, i, 0});
  for (int i = 0; i < 10; ++i) polygon.push_back({10 - i, 10, 0});
  polygon.push_back({0, 10, 0});
  expect_covered(polygon, "square with straight corners");
  for (const auto& [a, b, c] : triangulate(polygon))
    EXPECT_GT(glm::length(area_vector(polygon, a, b, c)), 0.0);
}

TEST(Triangulate, covers_repeated_corners_spikes_and_seams) {
  expect_covered({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 2, 0}, {0, 2, 0}}, "repeated corners");
  expect_covered({{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, "spike outwards");
  expect_covered({{0, 0, 0},
                  {4, 0, 0},
                  {4, 4, 0},
                  {0, 4, 0},
                  {0, 0, 0},
                  {1, 1, 0},
                  {1, 3, 0},
                  {3, 3, 0},
                  {3, 1, 0},
                  {1, 1, 0}},
                 "square with a hole");
  expect_covered({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}},
                 "hourglass through a corner");
  for (const int holes : {1, 2, 5, 40})
    expect_covered(square_with_holes(holes), std::to_string(holes) + " holes");
}

TEST(Triangulate, covers_random_stars_of_all_sizes) {
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const size_t corners = 4 + random.below(60);
    const double scale = std::pow(10.0, random.uniform(-12, 12));
    const auto polygon = star(corners, [&](size_t) { return scale * random.uniform(0.01, 1); });
    expect_covered(polygon, "seed " + std::to_string(seed));
  }
}

TEST(Triangulate, covers_polygons_at_the_limits_of_double) {
  for (const double size : {1e-300, 1e-160, 1e160, 1e300}) {
    const auto triangles = triangulate({{0, 0, 0},
                                        {2 * size, 0, 0},
                                        {2 * size, size, 0},
                                        {size, size, 0},
                                        {size, 2 * size, 0},
                                        {0, 2 * size, 0}});
    Polygon unit{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    double sum = 0;
    for (const auto& [a, b, c] : triangles) sum += glm::length(area_vector(unit, a, b, c));
    EXPECT_DOUBLE_EQ(sum, 3.0) << size;
  }
}

TEST(Triangulate, creates_n_minus_2_triangles_for_any_polygon) {
  Random random(11);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (size_t n = 3; n < 60; ++n) {
    Polygon crossing, grid(n, Vec3(1)), line, holey;
    for (size_t i = 0; i < n; ++i) {
      crossing.push_back({random.unit(), random.unit(), random.unit()});
      line.push_back({static_cast<double>(random.below(5)), 0, 0});
      holey.push_back({random.below(4) == 0 ? kNaN : random.unit(), random.unit(), 0});
      grid[i] = {static_cast<double>(random.below(3)), static_cast<double>(random.below(3)), 0};
    }
    for (const Polygon& polygon : {crossing, grid, line, holey, Polygon(n, Vec3(1))}) {
      EXPECT_EQ(triangulate(polygon).size(), n - 2);
    }
  }
}

TEST(Triangulate, covers_polygons_of_two_hundred_thousand_corners) {
  Random random(5);
  constexpr size_t kCorners = 200'000;
  const std::vector<std::pair<const char*, Polygon>> polygons{
      {"circle", star(kCorners, [](size_t) { return 1.0; })},
      {"gear", star(kCorners, [](size_t i) { return i % 2 ? 1.0 : 0.99; })},
      {"star", star(kCorners, [&](size_t) { return random.uniform(0.1, 1); })},
      {"stairs", stairs(kCorners / 4)}};
  for (const auto& [name, polygon] : polygons) {
    const auto triangles = triangulate(polygon);
    double sum = 0, whole = 0;
    for (const auto& [a, b, c] : triangles) sum += area_vector(polygon, a, b, c).z;
    for (uint32_t i = 1; i + 1 < kCorners; ++i) whole += area_vector(polygon, 0, i, i + 1).z;
    EXPECT_NEAR(sum, whole, 1e-9 * whole) << name;
  }
}

}  // namespace
}  // namespace kerf
