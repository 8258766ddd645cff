// What holds for heat on every mesh, whatever the step.
#include "core/heat/face_heat.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "tests/core/heat/heated_plates.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

// A mesh of mild steel with random temperatures up to some beyond the melting point; some faces are cold.
HeatedMesh randomly_hot(const Soup& soup, Random& random) {
  HeatedMesh hot(build(soup).mesh);
  hot.substance = Substance();
  for_each_face(hot.mesh, [&](FaceId f) {
    if (random.below(3) == 0) return;
    const double mass = triangle_area(hot.mesh.triangle(f)) * kSheet * hot.substance.density;
    hot.heat.set_energy(hot.mesh, f, mass * random.uniform(0, 1.2) * enthalpy_of_removal(hot.substance));
  });
  return hot;
}

double hottest(const HeatedMesh& hot) {
  double most = 0;
  for_each_face(hot.mesh, [&](FaceId f) { most = std::max(most, hot.rise(f)); });
  return most;
}

void split_and_remove_some(HeatedMesh& hot, Random& random, double& removed) {
  std::vector<Mesh::FaceSplit> splits;
  for (int i = 0; i < 10; ++i) {
    const FaceId f(static_cast<uint32_t>(random.below(hot.mesh.face_slots())));
    if (!hot.mesh.is_live(f)) continue;
    const auto corners = hot.mesh.corners(f);
    const size_t from = random.below(3);
    if (random.below(3) != 0) {
      hot.mesh.split_edge(f, corners[from], corners[(from + 1) % 3], splits);
    } else if (hot.mesh.live_faces() > 1) {
      removed += hot.heat.energy_of(hot.mesh, f);
      hot.mesh.remove_face(f);
    }
  }
}

TEST(Conduct, conserves_energy_between_splits_and_removals_on_every_mesh) {
  constexpr uint64_t kSeed = 21;
  Random random(kSeed);
  for (const auto& [name, soup] : mesh_classes()) {
    HeatedMesh hot = randomly_hot(soup, random);
    const double before = hot.heat.stored(hot.mesh);
    double lost = 0, removed = 0;
    for (int i = 0; i < 20; ++i) {
      split_and_remove_some(hot, random, removed);
      lost += hot.conduct(random.below(4) == 0 ? 1.0 : 1.0 / 120, {});
    }
    EXPECT_GE(lost, 0);
    EXPECT_NEAR(hot.heat.stored(hot.mesh) + lost + removed, before, 1e-12 * before)
        << name << ", seed " << kSeed;
  }
}

TEST(Conduct, conserves_energy_without_losses) {
  Random random(22);
  for (const auto& [name, soup] : mesh_classes()) {
    HeatedMesh hot = randomly_hot(soup, random);
    hot.substance.emissivity = 0;
    const double before = hot.heat.stored(hot.mesh);
    double rested = 0;
    for (int i = 0; i < 20; ++i) rested += hot.conduct(1.0 / 120);
    EXPECT_NEAR(hot.heat.stored(hot.mesh) + rested, before, 1e-12 * before) << name;
    EXPECT_LT(rested, 1e-3 * before) << name;
  }
}

TEST(Conduct, stays_between_ambient_and_the_previous_maximum) {
  constexpr uint64_t kSeed = 23;
  Random random(kSeed);
  for (const auto& [name, soup] : mesh_classes()) {
    for (const double step : {1e-9, 1.0 / 120, 1.0, 3600.0, 86400.0}) {
      SCOPED_TRACE(name + ", a step of " + std::to_string(step) + " s, seed " + std::to_string(kSeed));
      HeatedMesh hot = randomly_hot(soup, random);
      const double most = hottest(hot);
      hot.conduct(step, {});
      for_each_face(hot.mesh, [&](FaceId f) {
        ASSERT_TRUE(std::isfinite(hot.rise(f)));
        ASSERT_GE(hot.rise(f), 0);
        ASSERT_LE(hot.rise(f), most * (1 + 1e-6));
      });
      if (step == 86400.0) EXPECT_EQ(hot.heat.stored(hot.mesh), 0);
    }
  }
}

TEST(Conduct, a_plate_cools_to_ambient_and_records_no_heat) {
  HeatedMesh plate(build(grid(20, 0.05)).mesh);
  plate.substance = Substance();
  plate.deposit([](const Vec3& p) { return 500 * gaussian(glm::dot(p, p), 5e-3); }, {0, 0, 0}, 1);
  const double before = plate.heat.stored(plate.mesh);
  double lost = 0;
  int seconds = 0;
  for (; seconds < 3600 && plate.heat.stored(plate.mesh) > 0; ++seconds) lost += plate.conduct(1, {});
  EXPECT_LT(seconds, 3600);
  EXPECT_NEAR(lost, before, 1e-12 * before);
  plate.mesh.columns().for_each_set(plate.heat.energy, [](FaceId f) { ADD_FAILURE() << f.index; });
}

TEST(Conduct, folding_a_plate_has_no_effect) {
  const auto lines = graded(-5e-3, 5e-3, 0.5e-3, 0);
  const Soup flat = plate_of(lines, lines, Diagonals::kAlternating);
  Soup folded = flat;
  const double fold = lines[12];
  for (Vec3& p : folded.positions) {
    if (p.x > fold) p = {fold, p.x - fold, p.z};
  }
  HeatedMesh a(build(flat).mesh), b(build(folded).mesh);
  const FaceId hot(12 * 40 + 21);
  for (HeatedMesh* plate : {&a, &b}) {
    plate->heat.set_energy(plate->mesh, hot, 1);
    plate->conduct_in_steps(0.5, 1.0 / 120);
  }
  for_each_face(a.mesh, [&](FaceId f) { EXPECT_NEAR(a.rise(f), b.rise(f), 1e-6) << f.index; });
}

TEST(Conduct, faces_around_a_non_manifold_edge_share_heat_evenly) {
  HeatedMesh pages(build(book(5)).mesh);
  pages.substance.conductivity = 1e6;
  pages.heat.set_energy(pages.mesh, FaceId(2), 1e5);
  pages.conduct_in_steps(1000, 50);
  double least = 1e9, most = 0;
  for_each_face(pages.mesh, [&](FaceId f) {
    least = std::min(least, pages.rise(f));
    most = std::max(most, pages.rise(f));
  });
  EXPECT_GT(least, 0);
  EXPECT_NEAR(least, most, 1e-3 * most);
}

TEST(Conduct, records_peak_temperatures) {
  HeatedMesh plate(build(grid(10, 0.01)).mesh);
  plate.substance = Substance();
  const FaceId hot(100);
  const double mass = triangle_area(plate.mesh.triangle(hot)) * kSheet * plate.substance.density;
  plate.heat.set_energy(plate.mesh, hot, mass * enthalpy_at(plate.substance, 1500));
  for (int i = 0; i < 120; ++i) plate.conduct(1.0 / 120, {});
  EXPECT_NEAR(plate.heat.hottest_of(plate.mesh, hot), 1500, 0.01);
  EXPECT_EQ(plate.heat.hottest_of(plate.mesh, FaceId(0)), kAmbient);
}

}  // namespace
}  // namespace kerf::test
