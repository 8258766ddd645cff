#include "ui/editor/inspect/rim_circle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

// A circle in a random plane.
struct Circle {
  explicit Circle(Random& random) {
    radius = std::pow(10, random.uniform(-4, 3));
    centre = radius * Vec3(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    normal = glm::normalize(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)));
    u = glm::normalize(glm::cross(normal, Vec3(0.3, 1, 0.2)));
    v = glm::cross(normal, u);
  }
  Vec3 at(double angle) const { return centre + radius * (std::cos(angle) * u + std::sin(angle) * v); }
  double radius;
  Vec3 centre{0}, normal{0}, u{0}, v{0};
};

std::vector<double> random_angles(Random& random, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(random.uniform(0, 2 * kPi));
  std::sort(angles.begin(), angles.end());
  return angles;
}

TEST(FitCircle, finds_the_circle_of_points_at_random_angles) {
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const Circle circle(random);
    std::vector<Vec3> points;
    for (const double angle : random_angles(random, 3 + static_cast<int>(random.uniform(0, 60))))
      points.push_back(circle.at(angle));
    const auto fitted = fit_circle(points);
    ASSERT_TRUE(fitted) << "seed " << seed;
    const double tolerance = 1e-6 * circle.radius;  // a few random points may span a short arc
    EXPECT_NEAR(fitted->radius, circle.radius, tolerance) << "seed " << seed;
    EXPECT_LT(glm::length(fitted->centre - circle.centre), tolerance) << "seed " << seed;
    EXPECT_NEAR(std::abs(glm::dot(fitted->normal, circle.normal)), 1, 1e-9) << "seed " << seed;
    EXPECT_LT(fitted->deviation, tolerance) << "seed " << seed;
  }
}

// A wave of three periods moves neither the centre nor the radius in a closed form: its integral is 0.
TEST(FitCircle, averages_a_wave_and_states_its_height) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const Circle circle(random);
    const double height = random.uniform(0, 0.05) * circle.radius;
    std::vector<Vec3> points;
    for (int i = 0; i < 720; ++i) {
      const double angle = 2 * kPi * i / 720;
      points.push_back(circle.centre + (circle.at(angle) - circle.centre) *
                                           (1 + height / circle.radius * std::sin(3 * angle)));
    }
    const auto fitted = fit_circle(points);
    ASSERT_TRUE(fitted) << "seed " << seed;
    const double error = 2 * height * height / circle.radius + 1e-9 * circle.radius;
    EXPECT_NEAR(fitted->radius, circle.radius, error) << "seed " << seed;
    EXPECT_LT(glm::length(fitted->centre - circle.centre), error) << "seed " << seed;
    EXPECT_NEAR(fitted->deviation, height, error) << "seed " << seed;
  }
}

// Half of the points lie on a tenth of the circle: without weights they would draw the fit of a wave to it.
TEST(FitCircle, counts_finely_divided_stretches_by_their_length) {
  Random random(7);
  const Circle circle(random);
  const auto fitted_with = [&](int fine) {
    std::vector<Vec3> points;
    const auto add = [&](double angle) {
      points.push_back(circle.centre + (circle.at(angle) - circle.centre) * (1 + 0.02 * std::sin(2 * angle)));
    };
    for (int i = 0; i < fine; ++i) add(0.2 * kPi * i / fine);
    for (int i = 0; i < 900; ++i) add(0.2 * kPi + 1.8 * kPi * i / 900);
    return fit_circle(points).value();
  };
  const FittedCircle even = fitted_with(100), uneven = fitted_with(20'000);
  EXPECT_NEAR(even.radius, uneven.radius, 1e-4 * circle.radius);
  EXPECT_LT(glm::length(even.centre - uneven.centre), 1e-4 * circle.radius);
}

TEST(FitCircle, rejects_polygons_without_an_area) {
  EXPECT_FALSE(fit_circle(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}));
  EXPECT_FALSE(fit_circle(std::vector<Vec3>(5, Vec3(1, 2, 3))));
  EXPECT_FALSE(fit_circle(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
}

TEST(Rims, are_the_loops_of_open_edges) {
  const auto rims = rims_of(make_body("tube", test::build(test::tube(4, 32, 0.5, 2))));
  ASSERT_EQ(rims.size(), 2u);
  for (const std::vector<Vec3>& rim : rims) {
    EXPECT_EQ(rim.size(), 32u);
    EXPECT_NEAR(fit_circle(rim)->radius, 0.5, 1e-12);
  }
  EXPECT_TRUE(rims_of(make_body("sphere", test::build(test::sphere(8, 12, 1)))).empty());
  EXPECT_EQ(rims_of(make_body("grid", test::build(test::grid(5, 1)))).size(), 1u);
}

TEST(Rims, of_a_closed_mesh_bound_its_smooth_parts) {
  std::vector<double> radii;
  for (const std::vector<Vec3>& rim : rims_of(make_body("pipe", test::build(test::pipe(32, 0.5, 1, 0.2))))) {
    EXPECT_EQ(rim.size(), 32u);
    radii.push_back(fit_circle(rim)->radius);
  }
  std::sort(radii.begin(), radii.end());
  ASSERT_EQ(radii.size(), 8u);
  for (size_t i = 0; i < 8; ++i) EXPECT_NEAR(radii[i], i < 4 ? 0.5 : 1, 1e-12);
}

TEST(Rims, of_a_hole_with_few_sides_include_that_of_the_plane_around_it) {
  const auto rims = rims_of(make_body("pipe", test::build(test::pipe(6, 0.5, 1, 0.2))));
  const auto is_hole = [](const std::vector<Vec3>& rim) {
    return rim.size() == 6 && std::abs(fit_circle(rim)->radius - 0.5) < 1e-12;
  };
  EXPECT_EQ(std::count_if(rims.begin(), rims.end(), is_hole), 2);
}

}  // namespace
}  // namespace kerf
