#include "core/document/scene.h"
#include "core/base/json.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/document/save.h"
#include "core/mesh/looks.h"
#include "core/mesh/mesh_file.h"
#include "tests/support/checkout.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

TEST(Scene, reads_the_default_scene) {
  const auto scene = read_scene(checkout() / "assets/scenes/car.json");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_GE(scene->world.live_faces(), 3000u);
  EXPECT_LE(scene->world.live_faces(), 6000u);
  const Body& car = scene->world.body(scene->world.ids()[0]);
  for (const std::string& material : car.material_names)
    EXPECT_TRUE(scene->paints.contains(material) || material == "paint") << material;
  ASSERT_TRUE(car.looks && car.looks->surfaces());
  EXPECT_EQ(car.looks->surfaces()->images.size(), 1u);
  EXPECT_EQ(car.loaded.non_manifold_edges, 0u);
  EXPECT_EQ(car.loaded.repairs.degenerate_faces_dropped, 0u);
}

TEST(Scene, reports_progress_up_to_one_while_files_are_hashed) {
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
  ASSERT_TRUE(record_hashes(description, &progress).ok());
  EXPECT_NEAR(last, 1, 1e-9);
  for (const SceneBody& body : description.bodies) EXPECT_EQ(body.hash, description.bodies[0].hash);
}

// A scene of the sphere and this member beside it.
Result<Scene> scene_with(const std::string& name, const std::string& member) {
  const auto file = std::filesystem::path(testing::TempDir()) / ("kerf-scene-" + name + ".json");
  std::ofstream(file) << R"({"bodies": [{"mesh": ")" << checkout().string()
                      << R"(/assets/meshes/sphere.obj"}], )" << member << "}";
  Result<Scene> scene = read_scene(file);
  std::filesystem::remove(file);
  return scene;
}

TEST(Scene, reads_lights_and_display_options) {
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

TEST(Scene, may_have_four_lights) {
  const std::string light = R"({"direction": [0,1,0]})";
  const auto scene =
      scene_with("four", R"("lights": [)" + light + "," + light + "," + light + "," + light + "]");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->lights.size(), kMaxLights);
}

TEST(Scene, names_an_invalid_light_in_the_error) {
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

// A scene of a box, closed or without a face, whose body has this member as well.
class SolidScene : public testing::Test {
 protected:
  void write_box(bool closed) {
    Soup box = brick({1, 1, 1});
    if (!closed) box.triangles.pop_back();
    const MeshView view{box.positions, box.triangles, {}, {}, {}, {}, {}};
    ASSERT_TRUE(write_mesh(view, folder_ / "box.obj", MeshFormat::kObj).ok());
  }
  Result<Scene> read_with(const std::string& member) {
    write_text(folder_ / "scene.json", R"({"bodies": [{"mesh": "box.obj")" + member + "}]}");
    return read_scene(folder_ / "scene.json");
  }
  bool is_solid(const std::string& member) {
    const auto scene = read_with(member);
    return scene.ok() && scene->world.body(scene->world.ids().front()).solid;
  }

  TemporaryFolder folder_;
};

TEST_F(SolidScene, sets_solid_per_body_or_leaves_it_to_the_mesh) {
  for (const bool closed : {true, false}) {
    write_box(closed);
    EXPECT_FALSE(is_solid(""));
    EXPECT_FALSE(is_solid(R"(, "solid": false)"));
    EXPECT_TRUE(is_solid(R"(, "solid": true)"));
    EXPECT_EQ(is_solid(R"(, "solid": "auto")"), closed);
  }
}

TEST_F(SolidScene, is_solid_by_default_only_if_every_part_of_the_mesh_is_closed) {
  for (const Soup& beside : {sphere(6, 8, 0.2), plate(1)}) {
    const Soup parts = test::both(brick({1, 1, 1}), moved(beside, {3, 0, 0}, 1));
    const MeshView view{parts.positions, parts.triangles, {}, {}, {}, {}, {}};
    ASSERT_TRUE(write_mesh(view, folder_ / "box.obj", MeshFormat::kObj).ok());
    EXPECT_EQ(is_solid(R"(, "solid": "auto")"), beside.triangles.size() > 2);
  }
}

TEST_F(SolidScene, rejects_any_other_value) {
  write_box(true);
  for (const char* wrong : {"1", "\"yes\"", "null", "[true]"}) {
    const auto scene = read_with(std::string(R"(, "solid": )") + wrong);
    ASSERT_FALSE(scene.ok()) << wrong;
    EXPECT_NE(scene.error().message.find("/bodies/0/solid: must be true, false or \"auto\""),
              std::string::npos)
        << scene.error().message;
  }
}

TEST_F(SolidScene, saves_the_key_as_read_and_omits_it_without_solid_bodies) {
  write_box(true);
  for (const char* value : {"", "true", "\"auto\""}) {
    const auto scene = read_with(*value == 0 ? "" : std::string(R"(, "solid": )") + value);
    ASSERT_TRUE(scene.ok());
    ASSERT_TRUE(save_scene(folder_ / "again.json", *scene).ok());
    const auto json = nlohmann::json::parse(read_text(folder_ / "again.json"));
    const nlohmann::json& body = json["bodies"][0];
    EXPECT_EQ(body.contains("solid") ? body["solid"].dump() : "", value);
  }
}

TEST_F(SolidScene, keeps_solid_bodies_of_a_world_saved_as_a_scene) {
  write_box(true);
  const auto scene = read_with(R"(, "solid": "auto")");
  ASSERT_TRUE(scene.ok());
  const auto saved = save_world_as_scene(scene->world, {}, folder_ / "saved");
  ASSERT_TRUE(saved.ok());
  const auto again = read_scene(*saved);
  ASSERT_TRUE(again.ok());
  EXPECT_TRUE(again->world.body(again->world.ids().front()).solid);
  EXPECT_EQ(again->bodies[0].solid, Solidity::kSolid);
}

}  // namespace
}  // namespace kerf::test
