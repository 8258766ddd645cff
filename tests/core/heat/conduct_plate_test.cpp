// Conduction against the analytic solutions for a thin plate: superpositions of the Green function of the
// plane (Carslaw and Jaeger, Conduction of Heat in Solids, 1959). The figures are those of a plate of 1 mm of
// the reference steel; lengths in m, temperatures are rises in K.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/heat/heated_plates.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHeatPerVolume = 7800 * 600.0;           // J/(m^3 K)
constexpr double kHeatPerArea = kHeatPerVolume * kSheet;  // J/(m^2 K)
constexpr double kDiffusivity = 30 / kHeatPerVolume;      // m^2/s
constexpr double kWidth = 1e-3;                           // m, 1/e^2 radius of the beams
constexpr double kWithin = 0.02;

double squared(const Vec3& p) { return p.x * p.x + p.z * p.z; }

// A pulse of 10 J, Gaussian or, with w = 0, in a line through the plate; H is the loss of both sides.
double after_pulse(double distance2, double w, double time, double h) {
  const double spread = w * w + 8 * kDiffusivity * time;
  return 20 / (kPi * kHeatPerArea * spread) * std::exp(-2 * distance2 / spread - h * time / kHeatPerArea);
}

// A beam of 50 W that stands since `time`.
double under_beam(double distance2, double time) {
  const double factor = 50 / (4 * kPi * 30 * kSheet), spread = kWidth * kWidth + 8 * kDiffusivity * time;
  if (distance2 == 0) return factor * std::log(spread / (kWidth * kWidth));
  const auto e1 = [](double x) { return -std::expint(-x); };
  return factor * (e1(2 * distance2 / spread) - e1(2 * distance2 / (kWidth * kWidth)));
}

// A beam of 500 W that has moved along x at 10 mm/s for ever and is at the origin.
double behind_beam(const Vec3& p) {
  constexpr double kSpeed = 0.01, kRatio = 1.01;
  double sum = 0;
  for (double s = 1e-7; s < 30; s *= kRatio) {
    const double middle = s * std::sqrt(kRatio), spread = kWidth * kWidth + 8 * kDiffusivity * middle;
    const double along = p.x + kSpeed * middle;
    sum += s * (kRatio - 1) * 1000 / (kPi * kHeatPerArea * spread) *
           std::exp(-2 * (along * along + p.z * p.z) / spread);
  }
  return sum;
}

// The meshes on which conduction has to be right.
struct NamedMesh {
  std::string name;
  Mesh mesh;
};
std::vector<NamedMesh> meshes(double reach, double step) {
  const auto lines = graded(-reach, reach, step, 0);
  std::vector<NamedMesh> all;
  all.push_back({"alternating diagonals", build(plate_of(lines, lines, Diagonals::kAlternating)).mesh});
  all.push_back({"jittered Delaunay", jittered_plate(reach, 1.2 * step, 0.12, 7)});
  return all;
}

TEST(ConductPlate, a_line_pulse_spreads_like_the_green_function) {
  EXPECT_NEAR(after_pulse(0, 0, 0.1, 0), 265.2582, 1e-3);
  EXPECT_NEAR(after_pulse(4e-6, 0, 0.5, 0), 38.8328, 1e-3);
  EXPECT_NEAR(after_pulse(0, 0, 1, 200), 25.4161, 1e-3);
  for (auto& [name, mesh] : meshes(14e-3, 0.2e-3)) {
    for (const double h : {0.0, 200.0}) {
      SCOPED_TRACE(name + ", loss " + std::to_string(h));
      HeatedMesh plate(mesh);
      double area = 0;
      for_each_face(plate.mesh, [&](FaceId f) {
        if (glm::length(centroid(plate.mesh, f)) < 0.3e-3) area += triangle_area(plate.mesh.triangle(f));
      });
      plate.deposit([&](const Vec3&) { return 10 / area; }, {0, 0, 0}, 0.3e-3);
      double now = 0;
      const auto check = [&](double time, double step, const Vec3& at) {
        if (time > now) plate.conduct_in_steps(time - now, step, {.convection = h / 2});
        now = time;
        const auto expected = [&](const Vec3& p) { return after_pulse(squared(p), 0, time, h); };
        EXPECT_NEAR(plate.rise_over(expected, at, 0.4e-3), 1, kWithin) << time << " s, " << at.x << " m";
      };
      check(0.1, 2e-3, {0, 0, 0});
      check(0.1, 2e-3, {1e-3, 0, 0});
      check(0.1, 2e-3, {0, 0, 1e-3});
      check(0.5, 1e-2, {2e-3, 0, 0});
      check(1, 1e-2, {0, 0, 0});
    }
  }
}

TEST(ConductPlate, a_gaussian_pulse_widens_analytically) {
  EXPECT_NEAR(after_pulse(0, kWidth, 0, 0), 1360.2987, 1e-3);
  EXPECT_NEAR(after_pulse(1e-6, kWidth, 0.1, 0), 160.1639, 1e-3);
  EXPECT_NEAR(after_pulse(4e-6, kWidth, 1, 0), 22.3269, 1e-3);
  for (auto& [name, mesh] : meshes(14e-3, 0.2e-3)) {
    SCOPED_TRACE(name);
    HeatedMesh plate(mesh);
    plate.deposit([](const Vec3& p) { return 10 * gaussian(squared(p), kWidth); }, {0, 0, 0}, 4e-3);
    const auto ratio = [&](double time, const Vec3& at) {
      return plate.rise_over([&](const Vec3& p) { return after_pulse(squared(p), kWidth, time, 0); }, at,
                             0.4e-3);
    };
    EXPECT_NEAR(ratio(0, {0, 0, 0}), 1, kWithin);
    plate.conduct_in_steps(0.1, 2e-3);
    EXPECT_NEAR(ratio(0.1, {0, 0, 0}), 1, kWithin);
    for (const Vec3& at : {Vec3(1e-3, 0, 0), Vec3(0, 0, 1e-3), Vec3(7e-4, 0, 7e-4), Vec3(7e-4, 0, -7e-4)})
      EXPECT_NEAR(ratio(0.1, at), 1, kWithin) << at.x << " " << at.z;
    plate.conduct_in_steps(0.9, 1e-2);
    EXPECT_NEAR(ratio(1, {0, 0, 2e-3}), 1, kWithin);
  }
}

TEST(ConductPlate, a_stationary_beam_heats_analytically) {
  EXPECT_NEAR(under_beam(0, 0.1), 240.4436, 1e-3);
  EXPECT_NEAR(under_beam(0, 1), 524.7674, 1e-3);
  EXPECT_NEAR(under_beam(4e-6, 1), 191.9560, 1e-3);
  for (auto& [name, mesh] : meshes(14e-3, 0.2e-3)) {
    SCOPED_TRACE(name);
    HeatedMesh plate(mesh);
    const auto run = [&](double seconds, double step) {
      for (int i = 0; i < std::lround(seconds / step); ++i) {
        plate.deposit([&](const Vec3& p) { return 50 * step * gaussian(squared(p), kWidth); }, {0, 0, 0},
                      3e-3);
        plate.conduct(step);
      }
    };
    const auto ratio = [&](double time, const Vec3& at) {
      return plate.rise_over([&](const Vec3& p) { return under_beam(squared(p), time); }, at, 0.4e-3);
    };
    run(0.1, 2e-3);
    EXPECT_NEAR(ratio(0.1, {0, 0, 0}), 1, kWithin);
    EXPECT_NEAR(ratio(0.1, {2e-3, 0, 0}), 1, kWithin);
    run(0.9, 1e-2);
    EXPECT_NEAR(ratio(1, {0, 0, 0}), 1, kWithin);
    EXPECT_NEAR(ratio(1, {0, 0, 2e-3}), 1, kWithin);
  }
}

TEST(ConductPlate, a_moving_beam_heats_analytically) {
  EXPECT_NEAR(behind_beam({0, 0, 0}), 3113.86, 3);
  EXPECT_NEAR(behind_beam({-5e-3, 0, 0}), 1606.32, 2);
  EXPECT_NEAR(behind_beam({0, 0, 2e-3}), 605.21, 1);
  constexpr double kStart = -14e-3, kStep = 4e-3, kSpeed = 0.01;  // m, s, m/s
  HeatedMesh plate(build(plate_of(graded(kStart - 6e-3, 4e-3, 0.2e-3, 0), graded(-9e-3, 9e-3, 0.2e-3, 0),
                                  Diagonals::kAlternating))
                       .mesh);
  for (int i = 0; i < std::lround(-kStart / kSpeed / kStep); ++i) {
    const Vec3 beam(kStart + (i + 0.5) * kSpeed * kStep, 0, 0);
    plate.deposit([&](const Vec3& p) { return 500 * kStep * gaussian(squared(p - beam), kWidth); }, beam,
                  3e-3);
    plate.conduct(kStep);
  }
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(-1e-3, 0, 0), Vec3(-5e-3, 0, 0), Vec3(1e-3, 0, 0),
                         Vec3(0, 0, 1e-3), Vec3(0, 0, -1e-3), Vec3(0, 0, 2e-3)}) {
    EXPECT_NEAR(plate.rise_over(behind_beam, at, 0.3e-3), 1, kWithin) << at.x << " " << at.z;
  }
}

TEST(ConductPlate, finer_meshes_are_closer_to_the_solution) {
  double before = 1e9;
  for (const double step : {1e-3, 0.5e-3, 0.25e-3}) {
    const auto lines = graded(-6e-3, 6e-3, step, 0);
    HeatedMesh plate(build(plate_of(lines, lines, Diagonals::kAlternating)).mesh);
    plate.deposit([](const Vec3& p) { return 10 * gaussian(squared(p), kWidth); }, {0, 0, 0}, 5e-3);
    plate.conduct_in_steps(0.1, 0.25e-3);
    double worst = 0;
    for_each_face(plate.mesh, [&](FaceId f) {
      const Vec3 c = centroid(plate.mesh, f);
      if (squared(c) < 4e-6)
        worst = std::max(worst, std::abs(plate.rise(f) - after_pulse(squared(c), kWidth, 0.1, 0)));
    });
    EXPECT_LT(worst, 0.6 * before) << step;
    before = worst;
  }
  EXPECT_LT(before, 3);
}

}  // namespace
}  // namespace kerf::test
