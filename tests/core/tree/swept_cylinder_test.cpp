#include "core/tree/swept_cylinder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// Distance from p to the axis of the beam at the best moment of a translation, or infinity outside the range.
double distance_to_sweep(const Vec3& p, const Vec3& from, const Vec3& to, const Vec3& axis, Interval range,
                         int moments) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= moments; ++i) {
    const Vec3 o = from + (to - from) * (static_cast<double>(i) / moments);
    const double depth = glm::dot(p - o, axis);
    if (depth < range.low || depth > range.high) continue;
    best = std::min(best, glm::length(p - o - depth * axis));
  }
  return best;
}

struct Scene {
  Pose from, to;
  double radius;
  Interval range;
  Triangle triangle;
};

Scene random_scene(Random& random, bool along_axis) {
  Scene s;
  const Vec3 axis = random_direction(random);
  s.from = {random_direction(random) * random.uniform(0, 1), axis};
  Vec3 motion = random_direction(random) * random.uniform(0, 1);
  if (!along_axis) motion -= axis * glm::dot(motion, axis);
  s.to = {s.from.origin + motion, axis};
  s.radius = random.uniform(0.02, 0.4);
  s.range = {random.uniform(0, 0.5), random.uniform(0.5, 2)};
  const Vec3 centre =
      s.from.origin + axis * random.uniform(-0.5, 2) + random_direction(random) * random.uniform(0, 1);
  for (Vec3& p : s.triangle) p = centre + random_direction(random) * random.uniform(0.05, 0.6);
  return s;
}

// The nearest and farthest of many points of the triangle, as an oracle with a known error.
std::pair<double, double> sampled(const Scene& s, int grid, int moments) {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (int i = 0; i <= grid; ++i) {
    for (int j = 0; i + j <= grid; ++j) {
      const double u = static_cast<double>(i) / grid, v = static_cast<double>(j) / grid;
      const Vec3 p = (1 - u - v) * s.triangle[0] + u * s.triangle[1] + v * s.triangle[2];
      const double d = distance_to_sweep(p, s.from.origin, s.to.origin, s.from.direction, s.range, moments);
      nearest = std::min(nearest, d);
      farthest = std::max(farthest, d);
    }
  }
  return {nearest, farthest};
}

TEST(SweptCylinder, matches_sampling_for_a_translating_beam) {
  Random random(11);
  int touched = 0, missed = 0, contained = 0;
  for (int i = 0; i < 3000; ++i) {
    const Scene s = random_scene(random, false);
    const SweptCylinder beam(s.from, s.to, s.radius, s.range);
    const auto [nearest, farthest] = sampled(s, 24, 40);
    const double spacing = 1.3 / 24 + 1.0 / 40;
    if (nearest <= s.radius) {
      EXPECT_TRUE(beam.touches(s.triangle)) << "scene " << i;
      ++touched;
    }
    if (!std::isinf(nearest) && nearest > s.radius + spacing) {
      EXPECT_FALSE(beam.touches(s.triangle)) << "scene " << i;
      ++missed;
    }
    if (beam.contains(s.triangle)) EXPECT_LE(farthest, s.radius * (1 + 1e-12) + spacing) << "scene " << i;
    // The corners are among the samples, and a sampled distance is never too small.
    if (farthest <= s.radius * (1 - 1e-9)) {
      EXPECT_TRUE(beam.contains(s.triangle)) << "scene " << i;
      ++contained;
    }
  }
  EXPECT_GT(touched, 300);
  EXPECT_GT(missed, 300);
  EXPECT_GT(contained, 10);
}

TEST(SweptCylinder, never_misses_when_moving_along_its_axis_or_tilting) {
  Random random(12);
  for (int i = 0; i < 2000; ++i) {
    Scene s = random_scene(random, true);
    const SweptCylinder along(s.from, s.to, s.radius, s.range);
    if (sampled(s, 16, 30).first <= s.radius) EXPECT_TRUE(along.touches(s.triangle)) << "scene " << i;
    // A beam that tilts by a little meets what it meets at its start and at its end.
    Pose tilted = s.to;
    tilted.direction = glm::normalize(s.to.direction + 0.02 * random_direction(random));
    const SweptCylinder tilts(s.from, tilted, s.radius, s.range);
    for (const Pose& pose : {s.from, tilted}) {
      const SweptCylinder still(pose, pose, s.radius * 0.99, {s.range.low * 1.01, s.range.high * 0.98});
      if (still.touches(s.triangle)) EXPECT_TRUE(tilts.touches(s.triangle)) << "scene " << i;
    }
  }
}

TEST(SweptCylinder, keeps_its_radius_when_moving_along_an_oblique_axis) {
  Random random(14);
  for (int i = 0; i < 500; ++i) {
    const Vec3 axis = random_direction(random), origin = random_direction(random);
    const Vec3 sideways = glm::normalize(glm::cross(axis, random_direction(random)));
    const double radius = 0.05, away = random.uniform(0.06, 0.3);
    const SweptCylinder beam({origin, axis}, {origin + random.uniform(0, 1) * axis, axis}, radius, {0, 2});
    const Vec3 middle = origin + 1.5 * axis, lateral = middle + away * sideways;
    EXPECT_NEAR(beam.signed_distance(middle), -radius, 1e-12) << "scene " << i;
    EXPECT_NEAR(beam.signed_distance(lateral), away - radius, 1e-12) << "scene " << i;
    const Vec3 across = 0.01 * glm::cross(axis, sideways);
    EXPECT_TRUE(beam.touches({middle - across, middle + across, lateral})) << "scene " << i;
    EXPECT_FALSE(beam.touches({lateral - across, lateral + across, lateral + sideways})) << "scene " << i;
  }
}

// Over many moments, whose step bounds the error.
TEST(SweptCylinder, distances_match_sampling_for_a_translating_beam) {
  constexpr int kMoments = 1000;
  constexpr double kStep = 1.0 / kMoments;
  Random random(14);
  int outside = 0, inside = 0;
  for (int i = 0; i < 600; ++i) {
    const Scene s = random_scene(random, true);
    const SweptCylinder beam(s.from, s.to, s.radius, s.range);
    const Vec3 p = s.triangle[0], axis = s.from.direction;
    double distance = std::numeric_limits<double>::infinity(), overshoot = distance;
    for (int k = 0; k <= kMoments; ++k) {
      const Vec3 from = p - glm::mix(s.from.origin, s.to.origin, static_cast<double>(k) / kMoments);
      const double depth = glm::dot(from, axis), lateral = glm::length(from - depth * axis) - s.radius,
                   beyond = std::max(depth - s.range.high, s.range.low - depth);
      distance = std::min(distance, std::max(lateral, beyond));
      overshoot = std::min(overshoot, std::hypot(std::max(0.0, lateral), std::max(0.0, beyond)));
    }
    EXPECT_NEAR(beam.overshoot({p, p, p}), overshoot, kStep) << "scene " << i;
    EXPECT_NEAR(beam.signed_distance(p), distance, kStep) << "scene " << i;
    ++(distance > 0 ? outside : inside);
  }
  EXPECT_GT(outside, 200);
  EXPECT_GT(inside, 30);
}

TEST(SweptCylinder, ends_in_a_plane_at_its_range) {
  const Pose pose{{0, 1, 0}, {0, -1, 0}};
  const SweptCylinder beam(pose, pose, 0.1, {0.5, 0.9});
  const auto flat = [](double y) { return Triangle{Vec3(-1, y, -1), Vec3(1, y, -1), Vec3(0, y, 2)}; };
  EXPECT_TRUE(beam.touches(flat(0.5)));
  EXPECT_TRUE(beam.touches(flat(0.1)));
  EXPECT_FALSE(beam.touches(flat(0.5001)));
  EXPECT_FALSE(beam.touches(flat(0.0999)));
}

TEST(SweptCylinder, includes_its_boundary) {
  const Pose pose{{0, 1, 0}, {0, -1, 0}};
  const SweptCylinder beam(pose, pose, 0.25, {0, 2});
  EXPECT_TRUE(beam.touches({Vec3(0.25, 0, 0), Vec3(1, 0, -1), Vec3(1, 0, 1)}));
  EXPECT_FALSE(beam.touches({Vec3(std::nextafter(0.25, 1.0), 0, 0), Vec3(1, 0, -1), Vec3(1, 0, 1)}));
}

TEST(SweptCylinder, touches_triangles_of_any_size) {
  for (const int exponent : {-480, -260, 0, 260, 480}) {
    const double unit = std::ldexp(1.0, exponent);
    const Pose pose{{0, 2 * unit, 0}, {0, -1, 0}};
    const SweptCylinder beam(pose, pose, unit, {0, 4 * unit});
    const auto beside = [&](double x) {
      return Triangle{unit * Vec3(x, 0, -3), unit * Vec3(x, 0, 3), unit * Vec3(x + 3, 0, 0)};
    };
    EXPECT_TRUE(beam.touches(beside(0.5))) << exponent;
    EXPECT_FALSE(beam.touches(beside(1.5))) << exponent;
  }
}

// Every ray through a fan of triangles around a vertex touches at least one of them, also exactly through
// edges.
TEST(SweptCylinder, never_slips_between_neighbours_at_radius_zero) {
  Random random(13);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 axis = random_direction(random);
    std::vector<Vec3> rim;
    const int n = 5;
    for (int k = 0; k < n; ++k) {
      const double a = 6.283185307179586 * k / n;
      rim.push_back(Vec3(std::cos(a), 0.3 * random.unit(), std::sin(a)));
    }
    const Vec3 target = i % 2 == 0 ? Vec3(0) : rim[0] * 0.5;  // the vertex, or the middle of an edge
    if (std::abs(axis.y) < 0.6) continue;
    const Pose pose{target - 2.0 * axis, axis};
    const SweptCylinder ray(pose, pose, 0, {0, 10});
    bool any = false;
    for (int k = 0; k < n; ++k) any |= ray.touches({Vec3(0), rim[k], rim[(k + 1) % n]});
    EXPECT_TRUE(any) << "case " << i;
  }
}

}  // namespace
}  // namespace kerf::test
