#include "core/walls/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "tests/support/runs.h"

namespace kerf::test {
namespace {

using DiscMoves = std::vector<DiscMove>;

double distance_to_move(Vec2 p, const DiscMove& m) {
  const Vec2 way = m.to - m.from;
  const double length2 = glm::dot(way, way);
  const double share = length2 > 0 ? std::clamp(glm::dot(p - m.from, way) / length2, 0.0, 1.0) : 0;
  return glm::length(p - (m.from + share * way));
}

double distance_to_moves(Vec2 p, const DiscMoves& moves) {
  double least = std::numeric_limits<double>::infinity();
  for (const DiscMove& m : moves) least = std::min(least, distance_to_move(p, m));
  return least;
}

// The signed area on the left of a curve, whose gaps are closed by lines.
double enclosed_area(const OutlineCurve& curve) {
  double area = 0;
  for (size_t i = 0; i < curve.pieces.size(); ++i) {
    const OutlinePiece &p = curve.pieces[i], &next = curve.pieces[(i + 1) % curve.pieces.size()];
    if (p.radius > 0) {
      area += 0.5 * (p.radius * p.radius * p.turn + cross2(p.centre, p.to - p.from));
    } else {
      area += 0.5 * cross2(p.from, p.to);
    }
    area += 0.5 * cross2(p.to, next.from);
  }
  return area;
}

double enclosed_area(const std::vector<OutlineCurve>& curves) {
  double area = 0;
  for (const OutlineCurve& c : curves) area += enclosed_area(c);
  return area;
}

// What a horizontal line has in common with the region of a move; nothing where low > high.
struct Stretch {
  double low, high;
};
Stretch stretch_at(double y, const DiscMove& m, double radius) {
  Stretch s{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto take_in = [&](double x) { s = {std::min(s.low, x), std::max(s.high, x)}; };
  for (const Vec2 c : {m.from, m.to}) {
    const double half2 = radius * radius - (y - c.y) * (y - c.y);
    if (half2 < 0) continue;
    take_in(c.x - std::sqrt(half2));
    take_in(c.x + std::sqrt(half2));
  }
  const Vec2 way = m.to - m.from;
  if (way.y == 0) return s;
  const Vec2 left = Vec2(-way.y, way.x) * (radius / glm::length(way));
  for (const Vec2 start : {m.from - left, m.from + left}) {
    const double share = (y - start.y) / way.y;
    if (share >= 0 && share <= 1) take_in(start.x + share * way.x);
  }
  return s;
}

// The area that the discs sweep, from the lengths that so many horizontal lines have in common with it.
double swept_area(const DiscMoves& moves, double radius, int lines) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const DiscMove& m : moves) {
    low = std::min({low, m.from.y - radius, m.to.y - radius});
    high = std::max({high, m.from.y + radius, m.to.y + radius});
  }
  double length = 0;
  std::vector<Stretch> met;
  for (int i = 0; i < lines; ++i) {
    const double y = low + (high - low) * (i + 0.5) / lines;
    met.clear();
    for (const DiscMove& m : moves) {
      const Stretch s = stretch_at(y, m, radius);
      if (s.low < s.high) met.push_back(s);
    }
    std::sort(met.begin(), met.end(), [](const Stretch& a, const Stretch& b) { return a.low < b.low; });
    double reached = -std::numeric_limits<double>::infinity();
    for (const Stretch& s : met) {
      length += std::max(0.0, s.high - std::max(s.low, reached));
      reached = std::max(reached, s.high);
    }
  }
  return length * (high - low) / lines;
}

void expect_bounds_the_swept(const std::vector<OutlineCurve>& curves, const DiscMoves& moves, double radius) {
  ASSERT_FALSE(curves.empty());
  for (const OutlineCurve& curve : curves) {
    double length = 0;
    for (size_t i = 0; i < curve.pieces.size(); ++i) {
      const OutlinePiece &p = curve.pieces[i], &next = curve.pieces[(i + 1) % curve.pieces.size()];
      ASSERT_LE(glm::length(p.to - next.from), 1e-3 * radius) << "a gap";
      ASSERT_LT(p.side, 4 * moves.size());
      ASSERT_NEAR(p.length, p.radius > 0 ? p.radius * p.turn : glm::length(p.to - p.from), 1e-9 * p.length);
      length += p.length;
      for (int k = 0; k <= 8; ++k)
        ASSERT_NEAR(distance_to_moves(p.at(k / 8.0), moves), radius, 1e-6 * radius);
      const Vec2 middle = p.at(0.5), ahead = p.at(0.5 + 1e-3) - p.at(0.5 - 1e-3);
      const Vec2 left = Vec2(-ahead.y, ahead.x) / glm::length(ahead);
      ASSERT_LT(distance_to_moves(middle + 1e-3 * radius * left, moves), radius) << "it lies on the right";
    }
    ASSERT_NEAR(length, curve.length, 1e-9 * length);
  }
}

// A path through so many points; the moves of a random kind that people and files make.
void append_path(DiscMoves& moves, const std::vector<Vec2>& points) {
  for (size_t i = 0; i + 1 < points.size(); ++i) moves.push_back({points[i], points[i + 1]});
}

std::vector<Vec2> random_bends(Random& random, double step, size_t count) {
  std::vector<Vec2> points{{random.uniform(-1, 1), random.uniform(-1, 1)}};
  double heading = random.uniform(-kPi, kPi), bend = 0;
  for (size_t i = 0; i < count; ++i) {
    bend = 0.8 * bend + random.uniform(-0.25, 0.25);
    heading += bend;
    points.push_back(points.back() + step * Vec2(std::cos(heading), std::sin(heading)));
  }
  return points;
}

std::vector<Vec2> circle_of_points(Vec2 centre, double radius, int parts) {
  std::vector<Vec2> points;
  for (int i = 0; i <= parts; ++i) {
    const double angle = 2 * kPi * (i % parts) / parts;
    points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

constexpr double kRadius = 0.1;

DiscMoves random_moves(Random& random) {
  DiscMoves moves;
  const auto point = [&] { return Vec2(random.uniform(-1, 1), random.uniform(-1, 1)); };
  switch (random.below(6)) {
    case 0:  // a dense path
      append_path(moves, random_bends(random, kRadius * random.uniform(0.1, 0.5), 20 + random.below(80)));
      break;
    case 1: {  // there and back
      std::vector<Vec2> points = random_bends(random, kRadius * random.uniform(0.2, 2), 2 + random.below(20));
      append_path(moves, points);
      std::reverse(points.begin(), points.end());
      append_path(moves, points);
      break;
    }
    case 2: {  // a line in parts, and some of it again
      const Vec2 from = point(), to = point();
      const uint64_t parts = 2 + random.below(20);
      std::vector<Vec2> points;
      for (uint64_t i = 0; i <= parts; ++i)
        points.push_back(from + (to - from) * (static_cast<double>(i) / static_cast<double>(parts)));
      append_path(moves, points);
      moves.push_back({points[0], points[1 + random.below(parts)]});
      break;
    }
    case 3:  // lines across each other
      for (uint64_t i = 2 + random.below(10); i > 0; --i) moves.push_back({point(), point()});
      break;
    case 4: {  // a circle, and a line across it
      append_path(moves, circle_of_points(point(), random.uniform(0.05, 0.8),
                                          3 + static_cast<int>(random.below(60))));
      moves.push_back({point(), point()});
      break;
    }
    default: {  // a polygon with a beam that rests at its corners
      std::vector<Vec2> points;
      for (uint64_t i = 2 + random.below(5); i > 0; --i) points.push_back(point());
      for (const Vec2 p : points) moves.push_back({p, p});
      append_path(moves, points);
    }
  }
  return moves;
}

TEST(Outline, lies_on_the_boundary_and_encloses_the_swept_area) {
  size_t holes = 0;
  for (uint64_t seed = 1; seed <= runs(1200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const DiscMoves moves = random_moves(random);
    const std::vector<OutlineCurve> curves = run_to_completion(outline_of(moves, kRadius));
    ASSERT_NO_FATAL_FAILURE(expect_bounds_the_swept(curves, moves, kRadius));
    const double area = swept_area(moves, kRadius, 8000);
    EXPECT_NEAR(enclosed_area(curves), area, 1e-4 * area);
    for (const OutlineCurve& c : curves) holes += enclosed_area(c) < 0;
  }
  EXPECT_GT(holes, runs(1200) / 10);
}

// Where regions touch in a point or along a line, there may be nothing.
TEST(Outline, of_lattice_lines_is_correct_whenever_it_exists) {
  constexpr double kSteps[] = {0.5, 1, 1.5, 2};  // of the lattice, over the radius
  const uint64_t count = runs(2400);
  size_t nothing = 0;
  for (uint64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double step = kRadius * kSteps[seed % 4];
    std::vector<Vec2> points;
    for (uint64_t i = 2 + random.below(8); i > 0; --i) {
      points.emplace_back(step * static_cast<double>(random.below(9)),
                          step * static_cast<double>(random.below(9)));
    }
    DiscMoves moves;
    append_path(moves, points);
    const std::vector<OutlineCurve> curves = run_to_completion(outline_of(moves, kRadius));
    nothing += curves.empty();
    if (curves.empty()) continue;
    ASSERT_NO_FATAL_FAILURE(expect_bounds_the_swept(curves, moves, kRadius));
    const double area = swept_area(moves, kRadius, 4000);
    EXPECT_NEAR(enclosed_area(curves), area, 1e-3 * area);
  }
  std::printf("no outline of %zu of %zu paths on a lattice\n", nothing, static_cast<size_t>(count));
  EXPECT_LE(nothing, std::max<uint64_t>(1, count / 50));
}

// One outer curve, and so many holes.
void expect_curves(const DiscMoves& moves, double radius, double area, size_t holes) {
  const std::vector<OutlineCurve> curves = run_to_completion(outline_of(moves, radius));
  ASSERT_NO_FATAL_FAILURE(expect_bounds_the_swept(curves, moves, radius));
  ASSERT_EQ(curves.size(), 1 + holes);
  EXPECT_NEAR(enclosed_area(curves), area, 1e-9 * area);
  EXPECT_EQ(std::count_if(curves.begin(), curves.end(), [](const auto& c) { return enclosed_area(c) < 0; }),
            holes);
}

TEST(Outline, of_a_line_is_a_stadium_in_one_or_many_parts_and_retraced) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double r = random.uniform(0.01, 1), length = random.uniform(0, 5), angle = random.uniform(-4, 4);
    const Vec2 from(random.uniform(-9, 9), random.uniform(-9, 9));
    const Vec2 along(std::cos(angle), std::sin(angle));
    const double area = kPi * r * r + 2 * r * length;
    expect_curves({{from, from + length * along}}, r, area, 0);
    DiscMoves parts;
    double at = 0;
    while (at < length) {
      const double next = std::min(length, at + random.uniform(0.1, 2));
      parts.push_back({from + at * along, from + next * along});
      if (random.below(2) == 0) parts.push_back({parts.back().to, parts.back().from});
      at = next;
    }
    expect_curves(parts, r, area, 0);
    expect_curves({{from, from}}, r, kPi * r * r, 0);
  }
}

TEST(Outline, of_a_cross_excludes_the_overlap_of_both_lines) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double r = 0.1, angle = random.uniform(0.5, kPi - 0.5), turn = random.uniform(-4, 4);
    const double a = random.uniform(1, 2), b = random.uniform(1, 2);
    const Vec2 first = a * Vec2(std::cos(turn), std::sin(turn));
    const Vec2 second = b * Vec2(std::cos(turn + angle), std::sin(turn + angle));
    // The strips have a rhombus in common.
    const double area = 2 * (kPi * r * r) + 2 * r * (2 * a + 2 * b) - 4 * r * r / std::sin(angle);
    expect_curves({{-first, first}, {-second, second}}, r, area, 0);
  }
}

TEST(Outline, of_a_closed_polygon_has_a_hole) {
  for (int corners = 3; corners <= 200; corners += corners < 12 ? 1 : 47) {
    SCOPED_TRACE(corners);
    const double r = 0.1, size = 1, half = kPi / corners;
    DiscMoves moves;
    append_path(moves, circle_of_points({2, -1}, size, corners));
    const double side = 2 * size * std::sin(half), apothem = size * std::cos(half);
    const double polygon = 0.5 * corners * side * apothem;
    const double outer = polygon + corners * side * r + kPi * r * r;
    const double hole = polygon * (apothem - r) * (apothem - r) / (apothem * apothem);
    expect_curves(moves, r, outer - hole, 1);
  }
}

TEST(Outline, of_separate_lines_has_one_curve_each) {
  const DiscMoves moves{{{0, 0}, {1, 0}}, {{0, 0.5}, {1, 0.5}}, {{0, 1}, {1, 1}}};
  const std::vector<OutlineCurve> curves = run_to_completion(outline_of(moves, 0.1));
  ASSERT_EQ(curves.size(), 3u);
  for (const OutlineCurve& c : curves) EXPECT_NEAR(enclosed_area(c), kPi * 0.01 + 0.2, 1e-12);
}

size_t parts_of_work(const DiscMoves& moves, double radius) {
  auto outline = outline_of(moves, radius);
  size_t parts = 1;
  while (!outline.resume()) ++parts;
  EXPECT_FALSE(outline.take().empty());
  return parts;
}

// The number of moves that lie within a radius of each other grows with that of all.
TEST(Outline, of_four_times_the_moves_takes_about_four_times_the_work) {
  const auto on_circle = [](int count) { return circle_of_points({2, -1}, 0.3, count); };
  const auto on_lines = [](int count) {
    std::vector<Vec2> points;
    for (int i = 0; i <= count; ++i) points.push_back({std::abs(1 - 4.0 * i / count), 0.7});
    return points;
  };
  const auto at_random = [](int count) {
    Random random(1);
    std::vector<Vec2> points;
    for (int i = 0; i <= count; ++i) points.push_back({random.uniform(0, 0.02), random.uniform(0, 0.02)});
    return points;
  };
  const auto parts = [](const std::vector<Vec2>& points) {
    DiscMoves moves;
    append_path(moves, points);
    return parts_of_work(moves, 0.05);
  };
  const auto expect_growth = [&](const auto& way) {
    const size_t one = parts(way(4000)), four = parts(way(16000));
    EXPECT_LT(four, 6 * one);
    std::printf("%zu and %zu parts of work\n", one, four);
  };
  expect_growth(on_circle);
  expect_growth(on_lines);
  expect_growth(at_random);
}

// The outline of a path on a cylinder is that of its copies in the plane, within one turn.
TEST(Outline, round_a_cylinder_closes_after_a_turn) {
  const double radius = 0.1, around = 3;
  std::vector<DiscMove> ring;
  for (int i = 0; i < 40; ++i) ring.push_back({{0, 0.1 * i}, {0, 0.1 * (i + 1)}});
  const auto curves = run_to_completion(outline_around(ring, radius, around));
  ASSERT_EQ(curves.size(), 2u);
  for (const OutlineCurve& curve : curves) EXPECT_NEAR(curve.length, around, 1e-3 * radius);
  // A helix of less than a turn, with its loop in one copy.
  std::vector<DiscMove> helix;
  for (int i = 0; i < 25; ++i)
    helix.push_back({{0.01 * i, 7 + 0.1 * i}, {0.01 * (i + 1), 7 + 0.1 * (i + 1)}});
  const auto flat = run_to_completion(outline_of(helix, radius));
  const auto round = run_to_completion(outline_around(helix, radius, around));
  ASSERT_EQ(flat.size(), 1u);
  ASSERT_EQ(round.size(), 1u);
  EXPECT_NEAR(flat[0].length, round[0].length, 1e-9);
}

}  // namespace
}  // namespace kerf::test
