
#include <gtest/gtest.h>

#include "core/game/vehicle/vehicle.h"
#include "tests/support/game_files.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// A vehicle that fires ahead, and a level sheet around the axis of its beam.
class Firing : public testing::Test {
 protected:
  BodyId add_sheet(double size, int cells, double metres_ahead) {
    const Pose muzzle = muzzle_pose(lone_.world, lone_.vehicle);
    return test::add(lone_.world, test::rectangle(size, size, cells),
                     muzzle.origin + metres_ahead * muzzle.direction);
  }

  // Fires for a tick in which the muzzle comes from beside and behind where it is (m).
  std::map<BodyId, StepResult> fire_once(double aside, double behind) {
    Gun& gun = lone_.vehicle.gun;
    gun.firing = true;
    gun.radius = 0.02;
    gun.last = muzzle_pose(lone_.world, lone_.vehicle);
    const Vec3 across(gun.last->direction.z, 0, -gun.last->direction.x);
    gun.last->origin -= aside * across + behind * gun.last->direction;
    PlacementsBefore before;
    for (const BodyId id : lone_.world.ids()) before[id] = lone_.world.body(id).placement;
    return fire(
        lone_.world, lone_.vehicle, Sight(lone_.world), [](BodyId) { return true; }, LaserRules{}, before);
  }

  size_t faces(BodyId id) const { return lone_.world.body(id).mesh.live_faces(); }

  test::LoneVehicle lone_;
};

TEST_F(Firing, splits_few_faces_as_the_muzzle_moves_across_a_sheet) {
  for (const double behind : {0.15, -0.15}) {
    const BodyId sheet = add_sheet(2, 4, 0.3);
    const auto cut = fire_once(0.15, behind);
    ASSERT_TRUE(cut.contains(sheet));
    EXPECT_FALSE(cut.at(sheet).delta.replaced) << "it failed";
    EXPECT_GT(cut.at(sheet).delta.removed_faces, 10u);
    EXPECT_LT(faces(sheet), 5'000u);
    lone_.world.remove(sheet);
  }
}

TEST_F(Firing, ends_a_cut_at_the_face_limit_and_marks_the_body_as_replaced) {
  const BodyId sheet = add_sheet(40, 141, 20);
  ASSERT_EQ(faces(sheet), 39'762u);
  const auto cut = fire_once(0.15, 0);
  ASSERT_TRUE(cut.contains(sheet));
  EXPECT_TRUE(cut.at(sheet).delta.replaced);
  EXPECT_GT(faces(sheet), kMaxFacesOfTarget - 1'000);
  EXPECT_LT(faces(sheet), kMaxFacesOfTarget + 100);
}

TEST_F(Firing, does_not_cut_a_body_with_too_many_faces) {
  const BodyId sheet = add_sheet(40, 150, 20);
  ASSERT_GT(faces(sheet), kMaxFacesOfTarget);
  EXPECT_FALSE(fire_once(0.15, 0).contains(sheet));
  EXPECT_EQ(faces(sheet), 45'000u);
}

}  // namespace
}  // namespace kerf
