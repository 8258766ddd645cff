#include "core/heat/face_heat.h"

#include <gtest/gtest.h>

#include "core/mesh/refinement.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

class HotPlate : public testing::Test {
 protected:
  HotPlate() : mesh_(std::move(build(grid(4, 1)).mesh)), heat_(FaceHeat::attach(mesh_)) {}

  Mesh mesh_;
  FaceHeat heat_;
  Substance steel_;
};

TEST_F(HotPlate, is_at_ambient_if_never_heated) {
  EXPECT_EQ(heat_.temperature(mesh_, FaceId(3), steel_, 0.001), kAmbient);
  EXPECT_EQ(heat_.hottest_of(mesh_, FaceId(3)), kAmbient);
  EXPECT_EQ(heat_.stored(mesh_), 0);
}

TEST_F(HotPlate, has_the_temperature_of_its_energy_per_mass) {
  const double mass = triangle_area(mesh_.triangle(FaceId(3))) * 0.002 * steel_.density;
  heat_.set_energy(mesh_, FaceId(3), mass * steel_.heat_solid * 500);
  EXPECT_NEAR(heat_.temperature(mesh_, FaceId(3), steel_, 0.002), kAmbient + 500, 1e-9);
  EXPECT_NEAR(heat_.temperature(mesh_, FaceId(3), steel_, 0.001), kAmbient + 1000, 1e-9) << "half the mass";
  EXPECT_EQ(heat_.temperature(mesh_, FaceId(4), steel_, 0.002), kAmbient);
}

TEST_F(HotPlate, sums_its_energy) {
  heat_.set_energy(mesh_, FaceId(3), 4);
  heat_.set_energy(mesh_, FaceId(9), 0.5);
  heat_.set_energy(mesh_, FaceId(3), 2);
  EXPECT_EQ(heat_.stored(mesh_), 2.5);
}

TEST_F(HotPlate, records_the_highest_temperature) {
  heat_.record_hottest(mesh_, FaceId(3), 900);
  heat_.record_hottest(mesh_, FaceId(3), 500);
  EXPECT_EQ(heat_.hottest_of(mesh_, FaceId(3)), 900);
  heat_.record_hottest(mesh_, FaceId(3), 901);
  EXPECT_EQ(heat_.hottest_of(mesh_, FaceId(3)), 901);
}

TEST_F(HotPlate, keeps_energy_and_temperature_when_faces_are_split) {
  heat_.set_energy(mesh_, FaceId(3), 50);
  const double before = heat_.temperature(mesh_, FaceId(3), steel_, 0.001);
  const auto c = mesh_.corners(FaceId(3));
  std::vector<Mesh::FaceSplit> splits;
  mesh_.split_edge_at(FaceId(3), c[0], c[1], 0.25 * mesh_.position(c[0]) + 0.75 * mesh_.position(c[1]),
                      splits);
  EXPECT_NEAR(heat_.stored(mesh_), 50, 1e-12);
  size_t hot = 0;
  for (uint32_t f = 0; f < mesh_.face_slots(); ++f) {
    if (!mesh_.is_live(FaceId(f)) || heat_.energy_of(mesh_, FaceId(f)) == 0) continue;
    EXPECT_NEAR(heat_.temperature(mesh_, FaceId(f), steel_, 0.001), before, 1e-9);
    ++hot;
  }
  EXPECT_EQ(hot, 2u);
}

}  // namespace
}  // namespace kerf::test
