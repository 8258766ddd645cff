#include "core/document/piece_outline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/deterministic_math.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

Extract whole(const Soup& soup) {
  World world = world_of(soup);
  const Body& body = only_body(world);
  return extract_faces(body, body.faces_of(0));
}

double area_of_lines(const std::vector<DrawnLine>& lines) {
  double area = 0;
  for (const DrawnLine& line : lines) {
    for (size_t i = 0; i < line.points.size(); ++i)
      area += cross2(line.points[i], line.points[(i + 1) % line.points.size()]) / 2;
  }
  return area;
}

Soup turned(Soup soup, const glm::dquat& by) {
  for (Vec3& p : soup.positions) p = by * p;
  return soup;
}

TEST(PieceOutline, a_flat_sheet_has_its_boundary_without_points_on_straight_lines) {
  const auto lines = flat_outline(whole(moved(grid(8, 2), {3, 0.5, 1}, 1)));
  ASSERT_TRUE(lines);
  ASSERT_EQ(lines->size(), 1u);
  EXPECT_EQ(lines->front().points.size(), 4u);
  EXPECT_TRUE(lines->front().closed);
  EXPECT_NEAR(area_of_lines(*lines), 4, 1e-12);
  // Seen from above, right is +x and up is -z.
  for (const Vec2& p : lines->front().points) {
    EXPECT_NEAR(std::abs(p.x - 3), 1, 1e-12);
    EXPECT_NEAR(std::abs(p.y + 1), 1, 1e-12);
  }
}

// In any position; the hole is clockwise.
TEST(PieceOutline, a_plate_has_the_outline_of_its_upper_side_with_holes) {
  for (const uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const glm::dquat by = axis_angle(random_direction(random), random.uniform(0, kPi));
    const int sectors = 24;
    const auto lines = flat_outline(whole(turned(pipe(sectors, 0.4, 1, 0.05), by)));
    ASSERT_TRUE(lines);
    ASSERT_EQ(lines->size(), 2u);
    const double area = sectors / 2.0 * std::sin(2 * kPi / sectors) * (1 - 0.4 * 0.4);
    EXPECT_NEAR(area_of_lines(*lines), area, 1e-9);
  }
}

// A closed plate of 1 m, with n by n squares above and below and n rectangles on each other side.
Soup plate_of_squares(int n, double height) {
  Soup soup;
  const Vec3 size(1, height, 1);
  const glm::ivec3 parts(n, 1, n);
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const int upper : {0, 1}) {
      for (int i = 0; i < parts[u] * parts[v]; ++i) {
        const auto corner = [&](int du, int dv) {
          Vec3 p(0);
          p[axis] = upper * size[axis];
          p[u] = size[u] * (i % parts[u] + du) / parts[u];
          p[v] = size[v] * (i / parts[u] + dv) / parts[v];
          soup.positions.push_back(p);
          return static_cast<uint32_t>(soup.positions.size() - 1);
        };
        const uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
        soup.triangles.push_back(upper ? std::array{a, b, c} : std::array{a, c, b});
        soup.triangles.push_back(upper ? std::array{a, c, d} : std::array{a, d, c});
      }
    }
  }
  return soup;
}

TEST(PieceOutline, faces_of_the_other_sides_may_be_the_largest) {
  const auto lines = flat_outline(whole(plate_of_squares(10, 0.2)));
  ASSERT_TRUE(lines);
  ASSERT_EQ(lines->size(), 1u);
  EXPECT_NEAR(area_of_lines(*lines), 1, 1e-12);
  double high = 0;
  for (const Vec2& p : lines->front().points) high = std::max(high, p.x);
  EXPECT_NEAR(high, 1, 1e-12) << "it is that of the upper side";
}

// A closed disc around the y axis whose upper and lower sides consist of rings.
Soup disc_of_rings(int sectors, int rings, double radius, double height) {
  Soup soup;
  const auto corner = [&](int ring, int sector, double y) {
    const double angle = 2 * kPi * (sector % sectors) / sectors, r = radius * ring / rings;
    return ring == 0 ? Vec3(0, y, 0) : Vec3(r * std::cos(angle), y, r * std::sin(angle));
  };
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), {a, b, c});
    soup.triangles.push_back({first, first + 1, first + 2});
  };
  for (int s = 0; s < sectors; ++s) {
    for (const double side : {1, -1}) {
      const double y = side * height / 2;
      const int from = side > 0 ? s : s + 1, to = side > 0 ? s + 1 : s;
      for (int ring = 0; ring < rings; ++ring) {
        const Vec3 a = corner(ring, from, y), c = corner(ring + 1, to, y);
        if (ring > 0) add(a, corner(ring, to, y), c);
        add(a, c, corner(ring + 1, from, y));
      }
    }
    const Vec3 above = corner(rings, s, height / 2), below = corner(rings, s + 1, -height / 2);
    add(above, corner(rings, s + 1, height / 2), below);
    add(above, below, corner(rings, s, -height / 2));
  }
  return soup;
}

TEST(PieceOutline, a_round_plate_may_have_many_sides_of_large_faces) {
  const int sectors = 64;
  const double radius = 0.05;
  const auto lines = flat_outline(whole(disc_of_rings(sectors, 8, radius, 0.02)));
  ASSERT_TRUE(lines);
  ASSERT_EQ(lines->size(), 1u);
  EXPECT_EQ(lines->front().points.size(), static_cast<size_t>(sectors));
  EXPECT_NEAR(area_of_lines(*lines), sectors / 2.0 * std::sin(2 * kPi / sectors) * radius * radius, 1e-12);
}

// A plate whose lower side is larger than its upper one by a share of its area.
Soup tapered(double share) {
  Soup soup = brick({1, 0.05, 1});
  const double scale = std::sqrt(1 / (1 + share));
  for (Vec3& p : soup.positions) {
    if (p.y > 0) p = {0.5 + scale * (p.x - 0.5), p.y, 0.5 + scale * (p.z - 0.5)};
  }
  return soup;
}

TEST(PieceOutline, a_plate_may_taper_by_one_percent_of_its_area) {
  EXPECT_TRUE(flat_outline(whole(tapered(0.005))));
  EXPECT_FALSE(flat_outline(whole(tapered(0.015))));
}

TEST(PieceOutline, other_pieces_have_none) {
  EXPECT_FALSE(flat_outline(whole(sphere(8, 12, 1))));
  EXPECT_FALSE(flat_outline(whole(tube(3, 12, 1, 1))));
  Soup bent = grid(4, 1);
  bent.positions[0].y = 0.01;
  EXPECT_FALSE(flat_outline(whole(bent)));
}

}  // namespace
}  // namespace kerf::test
