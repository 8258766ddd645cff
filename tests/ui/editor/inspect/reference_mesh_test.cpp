#include "ui/editor/inspect/reference_mesh.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

#include "core/mesh/mesh_file.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"
#include "ui/editor/inspect/scalar_map.h"

namespace kerf {
namespace {

constexpr double kSide = 0.5;

// A cube of 0.5 m around the origin, which grows by a factor.
Soup cube(double scale) { return test::moved(test::brick(Vec3(kSide)), Vec3(-scale * kSide / 2), scale); }

World world_of(const Soup& soup) {
  World world;
  world.add(make_body("part", test::build(soup)));
  return world;
}

class ReferenceMeshTest : public testing::Test {
 protected:
  std::filesystem::path written(const Soup& soup, MeshFormat format = MeshFormat::kObj) const {
    const std::filesystem::path file =
        folder_.path() / ("reference." + std::string(format_row(format).ending));
    MeshView mesh;
    mesh.positions = soup.positions;
    mesh.triangles = soup.triangles;
    EXPECT_TRUE(write_mesh(mesh, file, format));
    return file;
  }
  std::shared_ptr<const ReferenceMesh> loaded(const World& world, const Soup& soup,
                                              Alignment alignment = Alignment::kNone) const {
    auto reference = load_reference(world, {.file = written(soup), .alignment = alignment}, nullptr);
    EXPECT_TRUE(reference) << reference.error().message;
    return *reference;
  }

  test::TemporaryFolder folder_;
};

TEST_F(ReferenceMeshTest, distances_of_a_larger_cube_are_those_between_parallel_sides) {
  const World world = world_of(cube(1.2));
  const auto reference = loaded(world, cube(1));
  const double apart = 0.1 * kSide;
  EXPECT_TRUE(reference->closed);
  EXPECT_NEAR(reference->found.max, apart * std::sqrt(3.0), 1e-12);  // between the corners
  EXPECT_GT(reference->found.signed_by->min, 0);
  for (const float d :
       face_scalars(world.body(world.ids().front()), FaceQuantity::kDeviation, nullptr, reference.get()))
    EXPECT_NEAR(d, apart, 1e-6);  // the centroids of both triangles of a side lie above the smaller one
}

TEST_F(ReferenceMeshTest, a_smaller_cube_lies_inside_and_the_colours_are_symmetric) {
  const World world = world_of(cube(0.8));
  ScalarMap map;
  map.set_reference(loaded(world, cube(1)));
  map.show(FaceQuantity::kDeviation);
  map.update(world, {});
  EXPECT_EQ(map.scale(), ColourScale::kDiverging);
  EXPECT_NEAR(map.histogram().most, -0.1 * kSide, 1e-6);
  EXPECT_DOUBLE_EQ(map.range().low, -map.range().high);
}

TEST_F(ReferenceMeshTest, an_open_reference_gives_distances_without_sign) {
  const World world = world_of(cube(0.8));
  ScalarMap map;
  map.set_reference(loaded(world, test::moved(test::plate(2), {0, 0.5, 0}, 1)));
  map.show(FaceQuantity::kDeviation);
  map.update(world, {});
  EXPECT_EQ(map.scale(), ColourScale::kSequential);
  EXPECT_NEAR(map.histogram().least, 0.5 - 0.4 * kSide, 1e-6);
}

TEST_F(ReferenceMeshTest, a_moved_body_has_other_distances) {
  World world = world_of(cube(1));
  const BodyId id = world.ids().front();
  ScalarMap map;
  map.set_reference(loaded(world, cube(1)));
  map.show(FaceQuantity::kDeviation);
  map.update(world, {});
  EXPECT_EQ(map.histogram().most, 0);
  world.body(id).placement.position += Vec3(0, 2, 0);
  Delta delta;
  delta.moved = {id};
  map.follow(world, delta);
  EXPECT_TRUE(map.is_old());
  map.update(world, {});
  EXPECT_NEAR(map.histogram().most, 2, 1e-6);
}

TEST_F(ReferenceMeshTest, alignment_moves_the_distances_but_not_the_scene) {
  const World world = world_of(test::moved(cube(1), {3, -1, 2}, 1));
  EXPECT_GT(loaded(world, cube(1))->found.p95, 1);
  EXPECT_NEAR(loaded(world, cube(1), Alignment::kCentre)->found.max, 0, 1e-12);
}

TEST_F(ReferenceMeshTest, hidden_bodies_are_not_compared) {
  World world = world_of(cube(1));
  world.body(world.ids().front()).hidden = true;
  const auto reference = load_reference(world, {written(cube(1))}, nullptr);
  ASSERT_FALSE(reference);
  EXPECT_EQ(reference.error().message, "No piece is visible, so there is nothing to compare.");
}

TEST_F(ReferenceMeshTest, files_in_metres_are_compared_in_the_unit_of_the_document) {
  const World in_mm = world_of(cube(1000));
  for (const MeshFormat format : {MeshFormat::kGlb, MeshFormat::k3mf}) {
    const auto reference = load_reference(
        in_mm, {.file = written(cube(1), format), .document_unit = FileUnit::kMillimetre}, nullptr);
    ASSERT_TRUE(reference) << reference.error().message;
    EXPECT_NEAR((*reference)->found.max, 0, 1e-3);
  }
}

TEST_F(ReferenceMeshTest, files_in_millimetres_are_compared_with_a_document_in_metres) {
  const auto reference =
      load_reference(world_of(cube(1.2)), {written(cube(1000), MeshFormat::kStl)}, nullptr);
  ASSERT_TRUE(reference) << reference.error().message;
  EXPECT_NEAR((*reference)->found.max, 0.1 * kSide * std::sqrt(3.0), 1e-6);
}

TEST_F(ReferenceMeshTest, files_with_the_numbers_of_the_document_are_not_scaled) {
  const World in_mm = world_of(cube(1000));
  for (const MeshFormat format : {MeshFormat::kGlb, MeshFormat::kObj, MeshFormat::kStl}) {
    const auto reference = load_reference(
        in_mm, {.file = written(cube(1000), format), .document_unit = FileUnit::kMillimetre}, nullptr);
    ASSERT_TRUE(reference) << reference.error().message;
    EXPECT_NEAR((*reference)->found.max, 0, 1e-3);
  }
}

TEST_F(ReferenceMeshTest, the_loader_reports_a_missing_file_and_can_be_cancelled) {
  const World world = world_of(cube(1));
  ReferenceLoader loader;
  loader.begin(world, {folder_.path() / "missing.obj"});
  EXPECT_TRUE(loader.busy());
  auto taken = loader.take();
  while (!taken) {
    std::this_thread::yield();
    taken = loader.take();
  }
  ASSERT_FALSE(*taken);
  EXPECT_NE(taken->error().message.find("missing.obj"), std::string::npos);
  EXPECT_FALSE(loader.busy());
  loader.begin(world, {written(cube(1))});
  loader.cancel();
  EXPECT_FALSE(loader.busy());
}

}  // namespace
}  // namespace kerf
