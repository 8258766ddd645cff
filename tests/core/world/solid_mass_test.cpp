
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/world/rigid_body.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

constexpr double kKgPerCubicMetre = 2700;

MassProperties solid_of(const Soup& soup, const Vec3& origin) {
  VolumeMoments sum;
  for (const auto& t : soup.triangles)
    sum += volume_moments({soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]}, origin);
  return solid_mass(sum, origin, kKgPerCubicMetre);
}

void expect_solid(const MassProperties& found, double mass, const Vec3& centre, const Vec3& inertia,
                  double tolerance) {
  EXPECT_NEAR(found.mass, mass, tolerance * mass);
  const double size2 = std::max({inertia.x, inertia.y, inertia.z}) / mass;
  EXPECT_NEAR(glm::length(found.centre - centre), 0, tolerance * std::sqrt(size2));
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(found.inertia[i][k], i == k ? inertia[i] : 0, tolerance * mass * size2) << i << k;
  }
}

TEST(SolidMass, of_a_box_is_exact_at_any_position_and_nearby_origin) {
  const Vec3 s(0.5, 0.3, 0.9), square = s * s;
  const double mass = kKgPerCubicMetre * s.x * s.y * s.z;
  const Vec3 inertia = mass / 12 * Vec3(square.y + square.z, square.z + square.x, square.x + square.y);
  for (const Vec3& at : {Vec3(0), Vec3(10, -20, 5)}) {
    for (const Vec3& origin : {at, at + 0.5 * s, at + Vec3(-1, 2, 0)})
      expect_solid(solid_of(moved(brick(s), at, 1), origin), mass, at + 0.5 * s, inertia, 1e-12);
  }
}

// What an inscribed mesh lacks falls with the square of the angle of a sector, and so do all the sums.
TEST(SolidMass, of_refined_balls_converges_to_that_of_a_ball) {
  const double r = 0.25, mass = kKgPerCubicMetre * 4 / 3 * std::numbers::pi * r * r * r;
  double before = 0;
  for (const int rings : {16, 32, 64}) {
    const MassProperties found = solid_of(sphere(rings, 2 * rings, r), Vec3(0.05, 0, 0));
    const double i = 2.0 / 5 * mass * r * r, missing = i - found.inertia[0][0];
    expect_solid(found, mass, Vec3(0), {i, i, i}, 10.0 / (rings * rings));
    EXPECT_GT(missing, 0);
    if (before > 0) EXPECT_NEAR(before / missing, 4, 0.1);
    before = missing;
  }
}

// The moments of a regular polygon with n corners at radius r are those of its area times r^2 / 12 *
// (2 + cos(2 pi / n)) about each axis in its plane.
TEST(SolidMass, of_a_pipe_matches_the_prism_around_a_regular_polygon) {
  const int n = 12;
  const double inner = 0.2, outer = 0.3, length = 0.7, turn = 2 * std::numbers::pi / n;
  const auto mass_in = [&](double r) { return kKgPerCubicMetre * length * 0.5 * n * r * r * std::sin(turn); };
  const auto spread_in = [&](double r) { return mass_in(r) * r * r / 12 * (2 + std::cos(turn)); };
  const double mass = mass_in(outer) - mass_in(inner), spread = spread_in(outer) - spread_in(inner);
  const double across = spread + mass * length * length / 12;
  expect_solid(solid_of(pipe(n, inner, outer, length), Vec3(0.1, 0.2, 0)), mass, Vec3(0),
               {across, 2 * spread, across}, 1e-12);
}

TEST(SolidMass, centre_of_half_a_ball_is_three_eighths_of_the_radius_off_centre) {
  const double r = 0.5;
  Soup half;
  const Soup ball = sphere(64, 128, r);
  for (const auto& t : ball.triangles) {
    const Vec3 &a = ball.positions[t[0]], &b = ball.positions[t[1]], &c = ball.positions[t[2]];
    if ((a + b + c).y <= 0) continue;
    const auto first = static_cast<uint32_t>(half.positions.size());
    half.positions.insert(half.positions.end(),
                          {a, b, c, Vec3(a.x, 0, a.z), Vec3(b.x, 0, b.z), Vec3(c.x, 0, c.z)});
    half.triangles.push_back({first, first + 1, first + 2});
    half.triangles.push_back({first + 3, first + 5, first + 4});
  }
  const MassProperties found = solid_of(half, Vec3(0, 0.2, 0));
  const double mass = kKgPerCubicMetre * 2 / 3 * std::numbers::pi * r * r * r;
  const double along = 2.0 / 5 * mass * r * r, across = 83.0 / 320 * mass * r * r;
  expect_solid(found, mass, {0, 3.0 / 8 * r, 0}, {across, along, across}, 5e-3);
}

TEST(SolidMass, is_zero_at_the_origin_without_volume) {
  for (const VolumeMoments& moments : {VolumeMoments{}, VolumeMoments{.volume = -1}}) {
    const MassProperties found = solid_mass(moments, {1, 2, 3}, kKgPerCubicMetre);
    EXPECT_EQ(found.mass, 0);
    EXPECT_EQ(found.centre, Vec3(1, 2, 3));
    EXPECT_EQ(found.inertia, glm::dmat3(0.0));
  }
}

TEST(CombineMass, two_halves_of_a_box_equal_the_box) {
  const Vec3 s(0.5, 0.3, 0.9), half(0.25, 0.3, 0.9);
  const MassProperties left = solid_of(brick(half), Vec3(0)),
                       right = solid_of(moved(brick(half), {0.25, 0, 0}, 1), Vec3(0)),
                       whole = solid_of(brick(s), Vec3(0)), both_halves = combine(left, right);
  const Vec3 inertia(whole.inertia[0][0], whole.inertia[1][1], whole.inertia[2][2]);
  expect_solid(both_halves, whole.mass, whole.centre, inertia, 1e-12);
}

TEST(CombineMass, adding_zero_mass_changes_nothing) {
  const MassProperties box = solid_of(brick({1, 2, 3}), Vec3(0)), nothing{0, {7, 8, 9}, glm::dmat3(0.0)};
  for (const MassProperties& found : {combine(box, nothing), combine(nothing, box)}) {
    EXPECT_EQ(found.mass, box.mass);
    EXPECT_EQ(found.centre, box.centre);
    EXPECT_EQ(found.inertia, box.inertia);
  }
  EXPECT_EQ(combine(nothing, {}).centre, nothing.centre);
}

}  // namespace
}  // namespace kerf::test
