#include "core/laser/compensation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "core/laser/segment_grid.h"

namespace kerf::test {
namespace {

double signed_area_of(const DrawnLine& line) {
  double area = 0;
  for (size_t i = 0; i < line.points.size(); ++i)
    area += 0.5 * cross2(line.points[i], line.points[(i + 1) % line.points.size()]);
  return area;
}

double distance_to_line(const DrawnLine& line, Vec2 point) {
  double distance = 1e300;
  for (size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i)
    distance =
        std::min(distance, distance_to({line.points[i], line.points[(i + 1) % line.points.size()]}, point));
  return distance;
}

bool is_inside(const DrawnLine& line, Vec2 p) {
  double turns = 0;
  for (size_t i = 0; i < line.points.size(); ++i) {
    const Vec2 a = line.points[i] - p, b = line.points[(i + 1) % line.points.size()] - p;
    turns += std::atan2(cross2(a, b), glm::dot(a, b));
  }
  return std::abs(turns) > kPi;
}

DrawnLine circle_line(Vec2 centre, double radius, size_t n) {
  DrawnLine line{{}, true, ""};
  for (size_t i = 0; i < n; ++i) {
    const double t = 2 * kPi * static_cast<double>(i) / static_cast<double>(n);
    line.points.push_back(centre + radius * Vec2(std::cos(t), std::sin(t)));
  }
  return line;
}

// A star-shaped line with bays that are narrower than the beam.
DrawnLine ragged_line(uint64_t seed) {
  Random random(seed);
  DrawnLine line{{}, true, ""};
  constexpr size_t kCorners = 40;
  for (size_t i = 0; i < kCorners; ++i) {
    const double t = 2 * kPi * static_cast<double>(i) / kCorners, r = random.uniform(4, 10);
    line.points.push_back(r * Vec2(std::cos(t), std::sin(t)));
  }
  return line;
}

DrawnLine square_line(Vec2 corner, double side) {
  return {{corner, corner + Vec2(side, 0), corner + Vec2(side), corner + Vec2(0, side)}, true, ""};
}

TEST(Compensation, a_square_grows_with_round_corners_and_shrinks_with_sharp_ones) {
  const DrawnLine square = square_line({0, 0}, 10);  // counter-clockwise
  const auto outer = offset_line(square, PathSide::kRight, 1),
             inner = offset_line(square, PathSide::kLeft, 1);
  ASSERT_TRUE(outer.ok() && inner.ok());
  ASSERT_EQ(outer->size(), 1u);
  ASSERT_EQ(inner->size(), 1u);
  EXPECT_NEAR(signed_area_of((*outer)[0]), 100 + 40 + kPi, 0.01);
  EXPECT_NEAR(signed_area_of((*inner)[0]), 64, 1e-12);
  EXPECT_TRUE(offset_line(square, PathSide::kLeft, 5.1)->empty());
}

TEST(Compensation, circles_stay_circles) {
  const DrawnLine circle = circle_line({3, 4}, 5, 300);
  for (const double r : {0.01, 0.5, 4.0}) {
    for (const PathSide side : {PathSide::kLeft, PathSide::kRight}) {
      const auto made = offset_line(circle, side, r);
      ASSERT_TRUE(made.ok());
      ASSERT_EQ(made->size(), 1u);
      EXPECT_TRUE((*made)[0].closed);
      const double wanted = side == PathSide::kLeft ? 5 - r : 5 + r;
      for (const Vec2& point : (*made)[0].points) EXPECT_NEAR(glm::length(point - Vec2(3, 4)), wanted, 1e-3);
    }
  }
}

TEST(Compensation, a_line_that_runs_back_along_itself_is_rounded_at_its_end) {
  const DrawnLine back{{{0, 0}, {10, 0}, {0, 0}}, false, ""};
  for (const PathSide side : {PathSide::kLeft, PathSide::kRight}) {
    const auto made = offset_line(back, side, 1);
    ASSERT_TRUE(made.ok());
    ASSERT_EQ(made->size(), 1u);
    EXPECT_LT(distance_to_line((*made)[0], {11, 0}), 0.01);
    for (const Vec2& point : (*made)[0].points) EXPECT_NEAR(distance_to_line(back, point), 1, 0.01);
  }
}

// Everything at the radius from the line, on the side, is on the compensated path, and nothing of that is
// nearer.
TEST(Compensation, wins_back_the_drawing_to_two_percent_of_the_radius) {
  constexpr double kRadius = 0.7, kAllowed = 0.02 * kRadius;
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const DrawnLine line = ragged_line(seed);
    for (const PathSide side : {PathSide::kLeft, PathSide::kRight}) {
      const bool inside = side == PathSide::kLeft;
      const auto made = offset_line(line, side, kRadius);
      ASSERT_TRUE(made.ok());
      for (const DrawnLine& path : *made) {
        EXPECT_TRUE(path.closed) << "seed " << seed;
        for (size_t i = 0; i < path.points.size(); ++i) {
          const Vec2 a = path.points[i], b = path.points[(i + 1) % path.points.size()];
          for (const double share : {0.0, 0.5}) {
            const Vec2 point = a + share * (b - a);
            EXPECT_NEAR(distance_to_line(line, point), kRadius, kAllowed) << "seed " << seed;
            EXPECT_EQ(is_inside(line, point), inside) << "seed " << seed;
          }
        }
      }
      // A probe on the side at the radius touches a path.
      Random random(seed + 1000);
      for (int probe = 0; probe < 400; ++probe) {
        const size_t i = random.below(line.points.size());
        const Vec2 a = line.points[i], b = line.points[(i + 1) % line.points.size()],
                   d = glm::normalize(b - a);
        const Vec2 point = a + random.unit() * (b - a) + (inside ? kRadius : -kRadius) * Vec2(-d.y, d.x);
        if (distance_to_line(line, point) < kRadius * (1 - 1e-12)) continue;
        double nearest = 1e300;
        for (const DrawnLine& path : *made) nearest = std::min(nearest, distance_to_line(path, point));
        EXPECT_LT(nearest, kAllowed) << "seed " << seed;
      }
    }
  }
}

TEST(Compensation, inner_lines_come_first_and_run_against_the_line_around_them) {
  std::vector<DrawnLine> lines{square_line({0, 0}, 20), square_line({2, 2}, 10), square_line({4, 4}, 2),
                               square_line({30, 0}, 5)};
  alternate_directions(lines);
  EXPECT_GT(signed_area_of(lines[0]), 0);
  EXPECT_LT(signed_area_of(lines[1]), 0);
  EXPECT_GT(signed_area_of(lines[2]), 0);
  EXPECT_GT(signed_area_of(lines[3]), 0);
  order_inner_first(lines);
  const double areas[] = {4, -100, 400, 25};
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(signed_area_of(lines[i]), areas[i], 1e-12);
}

TEST(Compensation, holes_shrink_where_outlines_grow) {
  const auto path =
      make_toolpath({square_line({0, 0}, 20), square_line({5, 5}, 10)}, {PathSide::kRight, 1, 0, 0, 0});
  ASSERT_TRUE(path.ok());
  ASSERT_EQ(path->strokes.size(), 2u);
  EXPECT_NEAR(std::abs(signed_area_of(path->strokes[0])), 64, 1e-9);
  EXPECT_NEAR(signed_area_of(path->strokes[1]), 400 + 80 + kPi, 0.01);
}

TEST(Compensation, entries_begin_on_the_side_of_the_waste_and_touch_nothing) {
  const DrawnLine square = square_line({0, 0}, 20);
  const auto path = make_toolpath({square, square_line({22.5, 0}, 5)}, {PathSide::kRight, 1, 3, 0, 0});
  ASSERT_TRUE(path.ok());
  ASSERT_EQ(path->strokes.size(), 2u);
  for (const DrawnLine& stroke : path->strokes) {
    EXPECT_NEAR(glm::length(stroke.points[1] - stroke.points[0]), 3, 1e-12);
    EXPECT_EQ(stroke.points[1], stroke.points.back());
    EXPECT_FALSE(is_inside(square, stroke.points[0]));
    EXPECT_NEAR(distance_to_line(square, path->strokes[0].points[0]), 4, 1e-12);
  }
  EXPECT_TRUE(path->notes.empty());
}

TEST(Compensation, tabs_leave_bridges_of_their_width) {
  const auto path = make_toolpath({circle_line({0, 0}, 10, 720)}, {PathSide::kNone, 0.5, 0, 4, 1});
  ASSERT_TRUE(path.ok());
  ASSERT_EQ(path->strokes.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    const Vec2 end = path->strokes[i].points.back(), begin = path->strokes[(i + 1) % 4].points.front();
    EXPECT_NEAR(glm::length(begin - end), 2, 0.02);  // the width and two radii
  }
  const auto small = make_toolpath({circle_line({0, 0}, 0.4, 90)}, {PathSide::kNone, 0.5, 0, 4, 1});
  ASSERT_TRUE(small.ok());
  EXPECT_EQ(small->strokes.size(), 1u);
  EXPECT_EQ(small->notes, std::vector<std::string>{"1 line is too short for the tabs"});
}

}  // namespace
}  // namespace kerf::test
