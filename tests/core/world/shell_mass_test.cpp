
#include <gtest/gtest.h>

#include <cmath>

#include "core/world/rigid_body.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kThickness = 0.002, kDensity = 7800;  // m, kg/m^3
constexpr double kSigma = kThickness * kDensity;       // kg/m^2

MassProperties mass_of(const Soup& soup) {
  const Body body = make_body("shell", build(soup));
  const Piece& piece = body.pieces[0];
  return shell_mass(piece.area, piece.moments, body.middle(), kThickness, kDensity);
}

void expect_mass(const MassProperties& found, double mass, const Vec3& centre, const Vec3& inertia,
                 double tolerance) {
  EXPECT_NEAR(found.mass, mass, tolerance * mass);
  const double size2 = std::max({inertia.x, inertia.y, inertia.z}) / mass;
  EXPECT_NEAR(glm::length(found.centre - centre), 0, tolerance * std::sqrt(size2));
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(found.inertia[i][k], i == k ? inertia[i] : 0, tolerance * mass * size2) << i << k;
  }
}

Soup box(const Vec3& size) {
  Soup soup;
  for (int i = 0; i < 8; ++i)
    soup.positions.push_back({i & 1 ? size.x : 0, i & 2 ? size.y : 0, i & 4 ? size.z : 0});
  soup.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return soup;
}

TEST(ShellMass, of_a_plate_matches_a_rectangle_for_any_triangulation_and_position) {
  for (const int cells : {1, 2, 9}) {
    for (const Vec3& at : {Vec3(0), Vec3(1000, -2000, 500)}) {
      const double size = 0.8, mass = kSigma * size * size, i = mass * size * size / 12;
      const MassProperties found = mass_of(moved(grid(cells, size), at, 1));
      expect_mass(found, mass, mass_of(moved(plate(size), at, 1)).centre, {i, 2 * i, i}, 1e-9);
    }
  }
}

TEST(ShellMass, of_a_box_matches_its_six_sides) {
  const Vec3 s(0.5, 0.3, 0.9);
  double mass = 0;
  Vec3 spread(0);  // integral of x^2, y^2, z^2 about the centre
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const double side = 2 * kSigma * s[a] * s[b];  // both sides across axis k
    mass += side;
    spread[k] += side * s[k] * s[k] / 4;
    spread[a] += side * s[a] * s[a] / 12;
    spread[b] += side * s[b] * s[b] / 12;
  }
  const Vec3 inertia(spread.y + spread.z, spread.z + spread.x, spread.x + spread.y);
  expect_mass(mass_of(box(s)), mass, 0.5 * s, inertia, 1e-13);
}

// Inscribed meshes converge to the smooth shapes with the square of the angle of a sector.
TEST(ShellMass, of_a_fine_tube_matches_a_thin_cylinder) {
  const double r = 0.3, length = 0.8, mass = kSigma * 2 * kPi * r * length;
  const MassProperties found = mass_of(tube(10, 400, r, length));
  EXPECT_NEAR(found.mass, mass, 1e-4 * mass);
  const double across = mass * (r * r / 2 + length * length / 12), along = mass * r * r;
  Vec3 inertia(found.inertia[0][0], found.inertia[1][1], found.inertia[2][2]);
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(inertia[k] - along) < std::abs(inertia[axis] - along)) axis = k;
  }
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(inertia[k], k == axis ? along : across, 2e-4 * across) << k;
}

TEST(ShellMass, inertia_of_a_fine_sphere_is_two_thirds_of_mass_times_radius_squared) {
  const double r = 0.25, mass = kSigma * 4 * kPi * r * r, i = 2.0 / 3 * mass * r * r;
  expect_mass(mass_of(sphere(200, 400, r)), mass, Vec3(0), {i, i, i}, 3e-4);
}

TEST(ShellMass, of_an_empty_mesh_is_zero_at_the_origin) {
  const MassProperties found = shell_mass(0, {}, {1, 2, 3}, kThickness, kDensity);
  EXPECT_EQ(found.mass, 0);
  EXPECT_EQ(found.centre, Vec3(1, 2, 3));
  EXPECT_EQ(found.inertia, glm::dmat3(0.0));
}

}  // namespace
}  // namespace kerf::test
