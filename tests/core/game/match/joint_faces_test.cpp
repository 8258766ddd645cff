#include "core/game/match/match_world.h"

#include <gtest/gtest.h>

#include "tests/support/game_files.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

TEST(JointFaces, are_in_a_chassis_until_all_are_cut_off) {
  test::LoneVehicle lone;
  const JointFaces faces(lone.world.joints());
  Body& chassis = lone.world.body(lone.vehicle.chassis);
  EXPECT_TRUE(faces.any_in(chassis));
  std::vector<FaceId> removed;
  for (const Joint& joint : lone.world.joints().all) {
    if (joint.body != lone.vehicle.chassis) continue;
    for (const JointSide& side : joint.sides) {
      for (const uint32_t f : side.faces) {
        if (!chassis.mesh.is_live(FaceId(f))) continue;
        chassis.mesh.remove_face(FaceId(f));
        removed.push_back(FaceId(f));
      }
    }
  }
  EXPECT_FALSE(faces.any_in(chassis));
  EXPECT_GT(chassis.mesh.live_faces(), 0u);
  ASSERT_FALSE(removed.empty());
  EXPECT_TRUE(faces.any_of(chassis, {removed.back()}));
  for (uint32_t f = 0; f < chassis.mesh.face_slots(); ++f) {
    if (chassis.mesh.is_live(FaceId(f))) EXPECT_FALSE(faces.any_of(chassis, {FaceId(f)}));
  }
}

TEST(JointFaces, are_absent_from_a_body_loaded_without_joints) {
  test::LoneVehicle lone;
  const BodyId sheet = test::add(lone.world, test::rectangle(1, 1, 4), Vec3(0, 0, 9));
  EXPECT_FALSE(JointFaces(lone.world.joints()).any_in(lone.world.body(sheet)));
}

}  // namespace
}  // namespace kerf
