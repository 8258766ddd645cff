// Heat of single faces and of strips: melting, losses, Stefan's front.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/heat/heated_plates.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

constexpr double kTick = 1.0 / 120;

// One equilateral face with edges of 1 mm.
HeatedMesh lone_face() {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1e-3, 0, 0}, {0.5e-3, 0, std::sqrt(0.75) * 1e-3}};
  soup.triangles = {{0, 1, 2}};
  return HeatedMesh(build(soup).mesh);
}

double area_of(const HeatedMesh& face) { return triangle_area(face.mesh.triangle(FaceId(0))); }

void set_temperature(HeatedMesh& face, FaceId f, double temperature) {
  const double mass = triangle_area(face.mesh.triangle(f)) * kSheet * face.substance.density;
  face.heat.set_energy(face.mesh, f, mass * enthalpy_at(face.substance, temperature));
}

double temperature(const HeatedMesh& face) {
  return face.heat.temperature(face.mesh, FaceId(0), face.substance, kSheet);
}

// What both sides lose, W/m^2.
double loss_at(double t, double emissivity, double convection) {
  return 2 * (convection * (t - kAmbient) +
              emissivity * kStefanBoltzmann * (std::pow(t, 4) - std::pow(kAmbient, 4)));
}

TEST(ConductFace, melting_through_takes_the_time_of_its_energy) {
  HeatedMesh face = lone_face();
  face.substance.transition = kAmbient + 1511;
  face.substance.latent = 2.7e5;
  const double mass = area_of(face) * kSheet * face.substance.density;
  const double share = 3.5e6 * area_of(face) * kTick / 10;
  double time = 0;
  for (; face.heat.energy_of(face.mesh, FaceId(0)) < mass * enthalpy_of_removal(face.substance);
       time += kTick / 10) {
    face.heat.set_energy(face.mesh, FaceId(0), face.heat.energy_of(face.mesh, FaceId(0)) + share);
    face.conduct(kTick / 10);
  }
  EXPECT_NEAR(time, 2.622137, 1e-3 * 2.622137);
}

TEST(ConductFace, a_face_of_mild_steel_needs_the_removal_energy_of_the_table) {
  const Substance steel;
  HeatedMesh face = lone_face();
  EXPECT_NEAR(area_of(face) * kSheet * steel.density * enthalpy_of_removal(steel), 4.09373, 1e-4);
}

TEST(ConductFace, convection_cools_exponentially) {
  for (const double step : {kTick, 1.0, 46.8}) {
    HeatedMesh face = lone_face();
    set_temperature(face, FaceId(0), kAmbient + 1000);
    face.conduct_in_steps(46.8, step, {.convection = 50});
    EXPECT_NEAR(face.rise(FaceId(0)), 1000 / std::exp(1.0), 1e-3 * 1000 / std::exp(1.0)) << step;
  }
}

TEST(ConductFace, radiation_cools_by_the_fourth_power_law) {
  EXPECT_NEAR(std::pow(std::pow(1500.0, -3) + 6 * 0.8 * kStefanBoltzmann * 10 / 4680, -1.0 / 3), 1044.3741,
              1e-3);
  for (const double step : {kTick, 0.5, 10.0}) {
    HeatedMesh face = lone_face();
    face.substance.emissivity = 0.8;
    set_temperature(face, FaceId(0), 1500);
    double expected = 1500;
    for (int second = 0; second < 60; second += 10) {
      face.conduct_in_steps(10, step);
      for (int i = 0; i < 100000; ++i) {
        const double middle = expected - 0.5e-4 * loss_at(expected, 0.8, 0) / 4680;
        expected -= 1e-4 * loss_at(middle, 0.8, 0) / 4680;
      }
      EXPECT_NEAR(temperature(face), expected, 1e-3 * expected) << second << " s, steps of " << step;
    }
  }
}

TEST(ConductFace, a_beam_and_losses_reach_an_equilibrium) {
  for (const double flux : {1e4, 1e5, 1e6}) {
    double low = kAmbient, high = 3000;
    while (high - low > 1e-6) (loss_at(0.5 * (low + high), 0.8, 20) < flux ? low : high) = 0.5 * (low + high);
    HeatedMesh face = lone_face();
    face.substance.emissivity = 0.8;
    for (int i = 0; i < 400 / kTick; ++i) {
      face.heat.set_energy(face.mesh, FaceId(0),
                           face.heat.energy_of(face.mesh, FaceId(0)) + flux * area_of(face) * kTick);
      face.conduct(kTick, {.convection = 20});
    }
    EXPECT_NEAR(temperature(face), low, 1e-3 * low) << flux;
  }
}

// One-phase melting from a wall that is 600 K above the melting point, of a strip at the melting point: the
// front is at 2 lambda sqrt(a t), lambda = 0.692456 (Stefan's problem).
TEST(ConductFace, the_melting_front_matches_the_stefan_solution) {
  constexpr double kFace = 0.1e-3;
  for (const double step : {kTick / 128, kTick / 64}) {
    HeatedMesh strip(build(plate_of(graded(0, 6e-3, kFace, 0), {0, kFace}, Diagonals::kAlternating)).mesh);
    strip.substance.transition = 1811;
    strip.substance.latent = 2.7e5;
    for_each_face(strip.mesh, [&](FaceId f) { set_temperature(strip, f, 1811); });
    const auto front = [&] {
      double molten = 0;
      for_each_face(strip.mesh, [&](FaceId f) {
        const double area = triangle_area(strip.mesh.triangle(f));
        const double mass = area * kSheet * strip.substance.density;
        const double taken =
            strip.heat.energy_of(strip.mesh, f) / mass - enthalpy_before_transition(strip.substance);
        molten += area * std::min(1.0, taken / strip.substance.latent);
      });
      return molten / kFace;
    };
    double now = 0;
    for (const auto& [time, expected] : {std::pair(0.1, 1.108816e-3), std::pair(1.0, 3.506385e-3)}) {
      for (; now < time - 0.5 * step; now += step) {
        for_each_face(strip.mesh, [&](FaceId f) {
          if (centroid(strip.mesh, f).x < kFace) set_temperature(strip, f, 1811 + 600);
        });
        strip.conduct(step);
      }
      EXPECT_NEAR(front(), expected, kFace) << time << " s in steps of " << step;
    }
  }
}

TEST(ConductFace, melting_next_to_molten_metal_hardly_depends_on_the_step) {
  constexpr double kFace = 0.2e-3;
  std::vector<double> molten;
  for (const double step : {kTick / 64, kTick, 6 * kTick}) {
    HeatedMesh strip(build(plate_of(graded(0, 8e-3, kFace, 0), {0, kFace}, Diagonals::kAlternating)).mesh);
    strip.substance.transition = 1811;
    strip.substance.latent = 2.7e5;
    for_each_face(strip.mesh, [&](FaceId f) {
      const bool hot = centroid(strip.mesh, f).x < 2e-3;
      set_temperature(strip, f, hot ? 2400 : 1700);
    });
    strip.conduct_in_steps(0.1, step);
    double sum = 0;
    for_each_face(strip.mesh, [&](FaceId f) {
      const double mass = triangle_area(strip.mesh.triangle(f)) * kSheet * strip.substance.density;
      const double latent =
          strip.heat.energy_of(strip.mesh, f) / mass - enthalpy_before_transition(strip.substance);
      sum += std::clamp(latent / strip.substance.latent, 0.0, 1.0) * triangle_area(strip.mesh.triangle(f));
    });
    molten.push_back(sum / kFace);
  }
  EXPECT_NEAR(molten[1], molten[0], 0.5 * kFace);
  EXPECT_NEAR(molten[2], molten[0], kFace);
}

}  // namespace
}  // namespace kerf::test
