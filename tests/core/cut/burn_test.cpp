#include "core/cut/thermal_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/deterministic_math.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// Two sheets under a beam of one ray.
class BurnTest : public testing::Test {
 protected:
  BurnTest() {
    for (const double height : {0.1, 0.0})
      world_.add(make_body("sheet", build(moved(grid(8, 0.02), {0, height, 0}, 1))));
    settings_.laser.radius = 0.001;
    settings_.laser.range = {0, 10};
    settings_.laser.pattern = Pattern::kVolume;
    for (const BodyId id : world_.ids()) bodies_.push_back({id, {}, {}, 0, {}});
  }
  double heat_in(size_t b) {
    const Body& body = world_.body(bodies_[b].id);
    double sum = 0;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) sum += body.heat.energy_of(body.mesh, FaceId(f));
    return sum;
  }

  World world_;
  CutSettings settings_;
  std::vector<BurnedBody> bodies_;
};

TEST_F(BurnTest, heats_the_next_sheet_after_faces_are_removed) {
  Burn burn(world_, settings_, bodies_, 1, [](size_t, FaceId) { return true; });
  const Pose pose{Vec3(0.0011, 1, 0.0007), Vec3(0, -1, 0)};
  burn.emit(pose, 1e-3);
  EXPECT_GT(heat_in(0), 0);
  EXPECT_EQ(heat_in(1), 0) << "the upper sheet is in the way";
  for (int i = 0; i < 10'000 && bodies_[0].removed.empty(); ++i) burn.emit(pose, 1);
  ASSERT_FALSE(bodies_[0].removed.empty());
  // All faces that the rays meet are gone in the end.
  for (int i = 0; i < 100'000 && heat_in(1) == 0; ++i) burn.emit(pose, 1);
  const double before = heat_in(1), upper = heat_in(0);
  ASSERT_GT(before, 0);
  const double absorbed = world_.energy().absorbed;
  burn.emit(pose, 1e-3);
  EXPECT_GT(heat_in(1), before);
  EXPECT_NEAR(heat_in(0) + heat_in(1) - upper - before, world_.energy().absorbed - absorbed, 1e-12);
}

TEST_F(BurnTest, heats_nothing_behind_a_sheet_that_absorbs_nothing) {
  world_.body(bodies_[0].id).sheet.substance.absorptivity_fibre = 0;
  Burn burn(world_, settings_, bodies_, 1, [](size_t, FaceId) { return true; });
  burn.emit({Vec3(0.0011, 1, 0.0007), Vec3(0, -1, 0)}, 1);
  EXPECT_EQ(heat_in(0), 0);
  EXPECT_EQ(heat_in(1), 0);
  EXPECT_EQ(world_.energy().absorbed, 0);
  EXPECT_NEAR(world_.energy().escaped, 1, 1e-12);
}

TEST_F(BurnTest, burns_a_sheet_next_to_a_cold_one) {
  world_.body(bodies_[0].id).placement.position.x = 10;
  settings_.laser.assist = Assist::kOxygen;
  Burn burn(world_, settings_, bodies_, 1, [](size_t, FaceId) { return true; });
  for (int i = 0; i < 10'000 && world_.energy().burnt == 0; ++i) {
    burn.emit({Vec3(0.0011, 1, 0.0007), Vec3(0, -1, 0)}, 0.1);
    burn.burn(1e-8, 0.03);
  }
  EXPECT_GT(world_.energy().burnt, 0);
  EXPECT_EQ(heat_in(0), 0);
}

TEST_F(BurnTest, waits_at_coarse_faces_that_it_would_remove) {
  Burn burn(world_, settings_, bodies_, 1, [](size_t, FaceId) { return false; });
  const Pose pose{Vec3(0.0011, 1, 0.0007), Vec3(0, -1, 0)};
  for (int i = 0; i < 10'000 && !burn.any_waiting() && bodies_[0].removed.empty(); ++i) burn.emit(pose, 1);
  EXPECT_TRUE(burn.any_waiting());
  EXPECT_TRUE(bodies_[0].removed.empty());
  EXPECT_FALSE(bodies_[0].coarse.empty());
}

// The waist lies on the upper sheet.
TEST_F(BurnTest, waits_within_the_waist_of_its_focus) {
  settings_.laser.radius = 2e-4;
  settings_.laser.focus = 0.9;
  Burn burn(world_, settings_, bodies_, 1, [](size_t, FaceId) { return false; });
  burn.emit({Vec3(0.0011, 1, 0.0007), Vec3(0, -1, 0)}, 1e9);
  EXPECT_TRUE(burn.any_waiting());
  EXPECT_GT(burn.waiting_within(), 1.5 * settings_.laser.radius);
  EXPECT_LT(burn.waiting_within(), 1.01 * kBundleReach * settings_.laser.radius);
}

// A tenth of a metre before the upper sheet lies the waist of a beam without a wavelength of its own.
TEST_F(BurnTest, widens_by_the_wavelength_of_the_first_body) {
  Substance& substance = world_.body(bodies_[0].id).sheet.substance;
  substance.wavelength = 10.6e-6;
  settings_.laser.radius = 2e-4;
  settings_.laser.focus = 0.8;
  Burn burn(world_, settings_, bodies_, 1, [](size_t, FaceId) { return false; });
  burn.emit({Vec3(0.0011, 1, 0.0007), Vec3(0, -1, 0)}, 1e9);
  EXPECT_TRUE(burn.any_waiting());
  const double rayleigh = kPi * settings_.laser.radius * settings_.laser.radius / substance.wavelength;
  const double widened = settings_.laser.radius * std::hypot(1, 0.1 / rayleigh);
  EXPECT_GT(burn.waiting_within(), 1.5 * widened);
  EXPECT_LT(burn.waiting_within(), 1.01 * kBundleReach * widened);
}

// However many rays met each of them.
TEST_F(BurnTest, shares_the_heat_of_burning_among_the_faces_hit_by_area) {
  Body& body = world_.body(bodies_[0].id);
  const Sheet& sheet = body.sheet;
  const double of_area = sheet.thickness * sheet.substance.density * enthalpy_at(sheet.substance, 1400);
  std::vector<double> cold, hit, area;
  const auto energies = [&] {
    std::vector<double> all;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f)
      all.push_back(body.heat.energy_of(body.mesh, FaceId(f)));
    return all;
  };
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    area.push_back(triangle_area(body.mesh.triangle(FaceId(f))));
    body.heat.set_energy(body.mesh, FaceId(f), of_area * area.back());
  }
  settings_.laser.assist = Assist::kOxygen;
  Burn burn(world_, settings_, bodies_, 1, [](size_t, FaceId) { return true; });
  cold = energies();
  burn.emit({Vec3(0.0011, 1, 0.0007), Vec3(0, -1, 0)}, 1e-3);
  hit = energies();
  burn.burn(1e-10, 0.01);
  const std::vector<double> burnt = energies();
  double area_hit = 0;
  for (size_t f = 0; f < area.size(); ++f) area_hit += hit[f] > cold[f] ? area[f] : 0;
  const double all = world_.energy().burnt;
  ASSERT_GT(area_hit, 2 * area[0]);
  ASSERT_GT(all, 0);
  for (size_t f = 0; f < area.size(); ++f) {
    const double share = hit[f] > cold[f] ? area[f] / area_hit : 0;
    EXPECT_NEAR(burnt[f] - hit[f], share * all, 1e-8 * all) << "face " << f;
  }
}

TEST_F(BurnTest, ignites_at_the_ignition_temperature) {
  Body& body = world_.body(bodies_[0].id);
  const Sheet& sheet = body.sheet;
  const double of_area = sheet.thickness * sheet.substance.density * enthalpy_at(sheet.substance, kKindling);
  // The nearest energy at which the face has just this temperature.
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    double joules = of_area * triangle_area(body.mesh.triangle(FaceId(f))) * (1 - 1e-15);
    do {
      joules = std::nextafter(joules, 1e9);
      body.heat.set_energy(body.mesh, FaceId(f), joules);
    } while (body.heat.temperature(body.mesh, FaceId(f), sheet.substance, sheet.thickness) < kKindling);
  }
  settings_.laser.assist = Assist::kOxygen;
  Burn burn(world_, settings_, bodies_, 1, [](size_t, FaceId) { return true; });
  burn.emit({Vec3(0.0011, 1, 0.0007), Vec3(0, -1, 0)}, 1e-200);
  burn.burn(1e-10, 0.01);
  EXPECT_GT(world_.energy().burnt, 0);
}

}  // namespace
}  // namespace kerf::test
