#include "core/walls/wall_chart_internal.h"

#include <gtest/gtest.h>

#include <locale>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "core/walls/make_walls.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

std::vector<BeamMove> zigzag(Random& random, bool from_apex) {
  std::vector<BeamMove> moves;
  const auto pose = [&](Vec2 p) {
    const Vec3 at(p.x, 0, p.y), apex(0, 4, 0);
    return from_apex ? Pose{apex, glm::normalize(at - apex)} : Pose{at + Vec3(0, 4, 0), Vec3(0, -1, 0)};
  };
  Vec2 p(0);
  for (uint64_t i = 0, count = 1 + random.below(60); i < count; ++i) {
    const Vec2 next = p + Vec2(random.uniform(0, 0.3), random.uniform(-0.1, 0.1));
    moves.push_back({pose(p), pose(next)});
    p = next;
  }
  return moves;
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(LeftOpen, names_the_place_independently_of_the_locale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  const std::string message = left_open("the rim crosses itself", {0.5, -1.25, 1e-9}).message;
  std::locale::global(before);
  EXPECT_EQ(message, "the rim crosses itself near (0.5, -1.25, 1e-09)");
}

TEST(WallChart, lists_corners_in_order_of_position) {
  for (uint64_t seed = 1; seed <= runs(50); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<BeamMove> moves = zigzag(random, seed % 2 == 0);
    const BeamPencil pencil = BeamPencil::all_of(moves, 0.05).front();
    const auto chart = run_to_completion(WallChart::make(pencil, moves, 0.05, {3.5, 4.5}));
    for (uint32_t c = 0; chart && c < chart->curves(); ++c) {
      const std::vector<double> corners = chart->corners(c, 0.1);
      ASSERT_GE(corners.size(), 3u);
      EXPECT_GE(corners.front(), 0);
      EXPECT_LT(corners.back(), chart->period(c));
      for (size_t i = 1; i < corners.size(); ++i) EXPECT_LT(corners[i - 1], corners[i]);
    }
  }
}

// Points on the boundary are found at their own place, wherever along the outline that is.
TEST(WallChart, finds_the_position_of_each_point) {
  size_t tried = 0;
  for (uint64_t seed = 1; seed <= runs(200); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<BeamMove> moves = zigzag(random, seed % 2 == 0);
    const double radius = 0.05;
    const BeamPencil pencil = BeamPencil::all_of(moves, radius).front();
    const auto chart = run_to_completion(WallChart::make(pencil, moves, radius, {3.5, 4.5}));
    if (!chart) continue;
    for (int i = 0; i < 100; ++i) {
      const auto curve = static_cast<uint32_t>(random.below(chart->curves()));
      const Vec3 p = chart->point_at({curve, random.uniform(0, chart->period(curve)), 4});
      const auto found = chart->place_of(p, 0.3 * radius);
      ASSERT_TRUE(found);
      EXPECT_LE(glm::length(chart->point_at(*found) - p), 1e-6 * radius);
      ++tried;
    }
  }
  EXPECT_GT(tried, 50u * runs(200));
}

// Beams towards an axis, along a path that goes round it and along it, or beside it.
std::vector<BeamMove> round_an_axis(Random& random, double turn, double offset) {
  std::vector<BeamMove> moves;
  const double along = random.uniform(-0.5, 0.5);
  const auto pose = [&](double angle) {
    const auto [sin, cos] = sin_cos(angle);
    const Vec3 out(0, cos, sin), beside(0, -sin, cos);
    return Pose{Vec3(along * angle, 0, 0) + 6.0 * out + offset * beside, -out};
  };
  const int count = static_cast<int>(turn / 0.04) + 1;
  for (int i = 0; i < count; ++i) moves.push_back({pose(turn * i / count), pose(turn * (i + 1) / count)});
  return moves;
}

TEST(WallChart, finds_positions_round_an_axis_even_after_several_turns) {
  size_t tried = 0;
  for (uint64_t seed = 1; seed <= runs(60); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double radius = 0.05, turns[] = {0.5, 3, 2 * kPi, 9};
    const double offset = seed % 3 == 0 ? random.uniform(-1, 1) : 0;
    const std::vector<BeamMove> moves = round_an_axis(random, turns[seed % 4], offset);
    std::optional<WallChart> chart;
    for (const BeamPencil& pencil : BeamPencil::all_of(moves, radius)) {
      if (pencil.kind() != BeamPencil::Kind::kTurning) continue;
      chart = run_to_completion(WallChart::make(pencil, moves, radius, {-4.5, -3.5}, {0, 6}));
      break;
    }
    if (!chart) continue;
    for (int i = 0; i < 100; ++i) {
      const auto curve = static_cast<uint32_t>(random.below(chart->curves()));
      const double depth = random.uniform(-4.5, -3.5);
      const Vec3 p = chart->point_at({curve, random.uniform(0, chart->period(curve)), depth});
      if (offset == 0) EXPECT_NEAR(std::hypot(p.y, p.z), -depth, 1e-12);
      const auto found = chart->place_of(p, 0.3 * radius);
      ASSERT_TRUE(found);
      EXPECT_LE(glm::length(chart->point_at(*found) - p), 1e-2 * radius);
      ++tried;
    }
  }
  EXPECT_GT(tried, 80u * runs(60));
}

}  // namespace
}  // namespace kerf
