#include "ui/figures/draw_figure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

double area(const DiagramTriangle& t) {
  return 0.5 * std::abs(cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]));
}

double sum_of_areas(const std::vector<DiagramTriangle>& stage) {
  double sum = 0;
  for (const DiagramTriangle& t : stage) sum += area(t);
  return sum;
}

// A point of the disc of the beam, from many of them, that lies in the triangle.
bool disc_meets(const DiagramTriangle& t, const Vec2& beam, double radius) {
  for (int i = 0; i <= 60; ++i) {
    for (int j = 0; j < 120; ++j) {
      const double r = radius * i / 60, a = 2 * 3.14159265358979 * j / 120;
      const Vec2 p = beam + r * Vec2(std::cos(a), std::sin(a));
      const double u = cross(t.corners[1] - t.corners[0], p - t.corners[0]);
      const double v = cross(t.corners[2] - t.corners[1], p - t.corners[1]);
      const double w = cross(t.corners[0] - t.corners[2], p - t.corners[2]);
      if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) return true;
    }
  }
  return false;
}

TEST(SplitDiagram, every_stage_covers_the_triangle_and_marks_parts_hit_by_the_beam) {
  const double whole = area({diagram_triangle(), false, false, {}, 0});
  const Vec2 beam(0.52, -0.33);
  const double radius = 0.13;
  const auto stages = split_stages(beam, radius);
  ASSERT_EQ(stages.size(), 4u);
  EXPECT_EQ(stages[0].size(), 1u);
  EXPECT_EQ(stages[1].size(), 4u);
  for (const auto& stage : stages) {
    EXPECT_NEAR(sum_of_areas(stage), whole, 1e-12);
    for (const DiagramTriangle& t : stage) EXPECT_EQ(t.hit, disc_meets(t, beam, radius));
  }
  for (const DiagramTriangle& t : stages[2]) {
    if (t.hit) {
      EXPECT_NEAR(area(t), whole / 16, 1e-12) << "what is hit is split twice";
    }
  }
  for (const DiagramTriangle& t : stages[3]) EXPECT_EQ(t.removed, t.hit);
}

TEST(SplitDiagram, a_closure_bisects_a_triangle_from_a_corner_to_an_edge_midpoint) {
  size_t halved = 0;
  for (const auto& stage : split_stages({0.52, -0.33}, 0.13)) {
    for (const DiagramTriangle& t : stage) {
      if (!t.bisected) continue;
      ++halved;
      const Vec2 middle = 0.5 * (t.corners[(t.corner + 1) % 3] + t.corners[(t.corner + 2) % 3]);
      EXPECT_LT(glm::length(middle - *t.bisected), 1e-12);
    }
  }
  EXPECT_GT(halved, 0u);
}

}  // namespace
}  // namespace kerf
