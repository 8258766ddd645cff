#include "core/document/files/scene.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/checkout.h"

namespace kerf::test {
namespace {

TEST(Scene, reads_the_default_scene) {
  const auto scene = read_scene(checkout() / "assets/scenes/car.json");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_GE(scene->world.live_faces(), 3000u);
  EXPECT_LE(scene->world.live_faces(), 6000u);
  const Body& car = scene->world.body(scene->world.ids()[0]);
  for (const std::string& material : car.material_names)
    EXPECT_TRUE(scene->paints.count(material)) << material;
  EXPECT_EQ(car.loaded.non_manifold_edges, 0u);
  EXPECT_EQ(car.loaded.repairs.degenerate_faces_dropped, 0u);
}

TEST(Scene, the_hashes_of_its_files_are_noted_with_a_progress_that_ends_at_one) {
  SceneDescription description;
  for (int i = 0; i < 5; ++i)
    description.bodies.emplace_back().mesh = checkout() / "assets/meshes/sphere.obj";
  double last = 0;
  const Progress progress{[&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1 + 1e-9);
    last = share;
    return true;
  }};
  ASSERT_TRUE(note_hashes(description, &progress).ok());
  EXPECT_NEAR(last, 1, 1e-9);
  for (const SceneBody& body : description.bodies) EXPECT_EQ(body.hash, description.bodies[0].hash);
}

// A scene of the sphere and this member beside it.
Result<Scene> scene_with(const std::string& name, const std::string& member) {
  const auto file = std::filesystem::temp_directory_path() / ("kerf-scene-" + name + ".json");
  std::ofstream(file) << R"({"bodies": [{"mesh": ")" << checkout().string()
                      << R"(/assets/meshes/sphere.obj"}], )" << member << "}";
  Result<Scene> scene = read_scene(file);
  std::filesystem::remove(file);
  return scene;
}

TEST(Scene, reads_lights_and_what_to_show) {
  const auto scene = scene_with("lights", R"("lights": [{"direction": [0, 2, 0]},
    {"position": [1, 2, 3], "colour": "#ff0000", "intensity": 0.5}], "show": ["shadows", "wire"])");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  ASSERT_EQ(scene->lights.size(), 2u);
  EXPECT_EQ(scene->lights[0].point(), (LightPoint{{0, 2, 0}, 0}));
  EXPECT_EQ(scene->lights[1].point(), (LightPoint{{1, 2, 3}, 1}));
  EXPECT_EQ(scene->lights[1].colour, Vec3(1, 0, 0));
  EXPECT_EQ(scene->lights[1].intensity, 0.5);
  EXPECT_EQ(scene->show, "shadows,wire");
}

TEST(Scene, says_what_is_wrong_with_a_light) {
  const std::pair<const char*, const char*> bad[]{
      {R"("lights": 1)", "/lights"},
      {R"("lights": [{}])", "/lights/0"},
      {R"("lights": [{"direction": [0,1,0], "position": [0,1,0]}])", "/lights/0"},
      {R"("lights": [{"direction": [0,0,0]}])", "/lights/0/direction"},
      {R"("lights": [{"direction": [0,1,0], "intensity": -1}])", "/lights/0/intensity"},
      {R"("lights": [{"direction": [0,1,0], "colour": "red"}])", "/lights/0/colour"},
      {R"("lights": [{"direction": [0,1,0]},{"direction": [0,1,0]},{"direction": [0,1,0]},{"direction": [0,1,0]},
        {"direction": [0,1,0]}])",
       "/lights"},
      {R"("show": "wire")", "/show"},
  };
  for (const auto& [member, where] : bad) {
    const auto scene = scene_with("bad", member);
    ASSERT_FALSE(scene.ok()) << member;
    EXPECT_EQ(scene.error().code, ErrorCode::kBadInput);
    EXPECT_NE(scene.error().message.find(std::string(where) + ": "), std::string::npos)
        << scene.error().message;
  }
}

}  // namespace
}  // namespace kerf::test
