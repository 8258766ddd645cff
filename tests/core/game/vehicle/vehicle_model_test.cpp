#include "core/game/vehicle/vehicle_model.h"

#include <gtest/gtest.h>

#include "core/mesh/mesh_file.h"
#include "tests/support/checkout.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

TEST(VehicleModel, names_a_part_missing_from_the_mesh) {
  auto vehicle = read_vehicle(test::checkout() / "assets/vehicles/hatchback.json");
  ASSERT_TRUE(vehicle);
  vehicle->wheels[1].part = "balloon";
  const auto model = load_vehicle(*vehicle);
  ASSERT_FALSE(model);
  EXPECT_NE(model.error().message.find("\"balloon\""), std::string::npos) << model.error().message;
}

TEST(VehicleModel, distributes_all_faces_of_the_mesh_to_its_bodies) {
  const auto model = test::hatchback();
  const auto soup = read_mesh(model->description.body.mesh);
  ASSERT_TRUE(soup);
  size_t faces = model->chassis.body.mesh.live_faces() + model->turret.body.mesh.live_faces() +
                 model->barrel.body.mesh.live_faces();
  for (const VehicleBody& wheel : model->wheels) faces += wheel.body.mesh.live_faces();
  EXPECT_EQ(faces, soup->triangles.size());
  for (const MeshPart& group : model->wheels[2].body.named_parts)
    EXPECT_TRUE(is_of_part(group.name, model->description.wheels[2].part)) << group.name;
}

TEST(VehicleModel, has_the_chassis_mass_of_its_file) {
  const auto model = test::hatchback();
  const Sheet& sheet = model->chassis.body.sheet;
  EXPECT_NEAR(sheet.density * sheet.thickness * model->chassis_area, model->description.mass, 1e-6);
  EXPECT_NEAR(model->chassis.body.loaded.area, model->chassis_area, 1e-9);
}

TEST(VehicleModel, watches_mounts_seats_and_vital_parts) {
  const auto model = test::hatchback();
  const size_t vitals = model->description.vitals.size();
  ASSERT_EQ(model->chassis.watch.size(), model->wheels.size() + 2 + vitals)
      << "the last one is the fuel tank";
  EXPECT_EQ(model->tank() + 1, model->chassis.watch.size());
  EXPECT_EQ(model->vital_centres.size(), vitals);
  for (size_t group = 0; group < model->chassis.watch.size(); ++group)
    EXPECT_GT(model->chassis.watch.area(group), 0);
  for (const VehicleBody& wheel : model->wheels) {
    EXPECT_NEAR(wheel.watch.area(VehicleModel::kAll), wheel.body.loaded.area, 1e-9);
    EXPECT_LT(wheel.watch.area(VehicleModel::kSeat), wheel.watch.area(VehicleModel::kAll));
  }
}

TEST(VehicleModel, keeps_joints_whose_parts_are_in_one_body) {
  const auto model = test::hatchback();
  EXPECT_FALSE(model->chassis.joints.empty());
  EXPECT_LE(model->chassis.joints.size(), model->description.body.joints.size());
}

}  // namespace
}  // namespace kerf
