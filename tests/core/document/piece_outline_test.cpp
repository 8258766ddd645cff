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

TEST(PieceOutline, other_pieces_have_none) {
  EXPECT_FALSE(flat_outline(whole(sphere(8, 12, 1))));
  EXPECT_FALSE(flat_outline(whole(tube(3, 12, 1, 1))));
  Soup bent = grid(4, 1);
  bent.positions[0].y = 0.01;
  EXPECT_FALSE(flat_outline(whole(bent)));
}

}  // namespace
}  // namespace kerf::test
