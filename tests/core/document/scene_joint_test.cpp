#include <gtest/gtest.h>

#include "core/document/scene.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

// Two triangles that are apart, in the objects door and frame; the second one is in two groups, too.
constexpr const char* kMesh =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\n"
    "o door\nf 1 2 3\no frame\ng steel painted\nf 4 5 6\n";

// What parse_scene makes of a body with these members.
Result<SceneDescription> described(const std::string& members) {
  static nlohmann::json json;
  json = *parse_json(R"({"bodies": [{"mesh": "mesh.obj", )" + members + "}]}", "scene.json");
  return parse_scene(JsonValue(json, "scene.json"), "folder");
}

// The same, with the mesh loaded.
Result<Scene> loaded(const std::string& members, const char* mesh = kMesh) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "mesh.obj", mesh);
  test::write_text(folder / "scene.json", R"({"bodies": [{"mesh": "mesh.obj", )" + members + "}]}");
  return read_scene(folder / "scene.json");
}

constexpr const char* kHinge =
    R"("joints": [{"kind": "hinge", "parts": ["door", "painted"], "anchor": [0, 0, 0.5], "axis": [0, 2, 0],
       "limits": [-10, 90]}])";

TEST(JointDescriptions, thickness_and_density_of_a_body_round_trip) {
  const auto scene = described(R"("thickness": 0.0008, "density": 2700)");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->bodies[0].sheet, (Sheet{0.0008, 2700, {}}));
  const nlohmann::ordered_json written = scene_json(*scene, "folder");
  EXPECT_EQ(written["bodies"][0]["thickness"], 0.0008);
  EXPECT_EQ(written["bodies"][0]["density"], 2700);
  EXPECT_EQ(loaded(R"("thickness": 0.003)")->world.body({0, 0}).sheet, (Sheet{0.003, Sheet{}.density, {}}));
}

TEST(JointDescriptions, omits_default_thickness_and_joints_when_written) {
  const nlohmann::ordered_json written = scene_json(*described(R"("name": "a")"), "folder");
  for (const char* key : {"thickness", "density", "joints"}) EXPECT_FALSE(written["bodies"][0].contains(key));
}

TEST(JointDescriptions, joints_round_trip) {
  const std::string text =
      R"("joints": [{"kind": "weld", "parts": ["a", "b"], "anchor": [1, 2, 3], "near": [[0, 0, 0], [1, 1, 1]],
         "radius": 0.5},
         {"kind": "hub", "parts": ["c", "d"], "anchor": [0, 0, 0], "axis": [1, 0, 0]},
         {"kind": "hinge", "parts": ["c", "d"], "anchor": [0, 0, 0], "axis": [1, 0, 0], "limits": [-5, 70.5]}])";
  const auto scene = described(text);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  ASSERT_EQ(scene->bodies[0].joints.size(), 3u);
  EXPECT_EQ(nlohmann::json(scene_json(*scene, "folder")["bodies"][0]["joints"]),
            nlohmann::json::parse("{" + text + "}")["joints"]);
}

TEST(JointDescriptions, errors_name_the_invalid_value) {
  const std::pair<const char*, const char*> bad[]{
      {R"("thickness": 0)", "/bodies/0/thickness: must be greater than zero"},
      {R"("thickness": 1e300)", "/bodies/0/thickness: must be from"},
      {R"("density": 1e-300)", "/bodies/0/density: must be from"},
      {R"("density": "steel")", "/bodies/0/density: must be"},
      {R"("joints": {})", "/bodies/0/joints: must be"},
      {R"("joints": [1])", "/bodies/0/joints/0: must be"},
      {R"("joints": [{"kind": "weld"}])", "/bodies/0/joints/0: needs \"parts\""},
      {R"("joints": [{"kind": "glue", "parts": ["a", "b"], "anchor": [0,0,0]}])", "/joints/0/kind: must be"},
      {R"("joints": [{"kind": "weld", "parts": ["a"], "anchor": [0,0,0]}])", "/joints/0/parts: must be two"},
      {R"("joints": [{"kind": "hub", "parts": ["a", "b"], "anchor": [0,0,0]}])", "/joints/0: needs \"axis\""},
      {R"("joints": [{"kind": "hub", "parts": ["a", "b"], "anchor": [0,0,0], "axis": [0,0,0]}])",
       "/axis: must"},
      {R"("joints": [{"kind": "weld", "parts": ["a", "b"], "anchor": [0,0,0], "axis": [1,0,0]}])",
       "/axis: a weld has no axis"},
      {R"("joints": [{"kind": "weld", "parts": ["a", "b"], "anchor": [0,0,0], "limits": [0,1]}])",
       "/limits: only"},
      {R"("joints": [{"kind": "hinge", "parts": ["a", "b"], "anchor": [0,0,0], "axis": [1,0,0],
          "limits": [10,20]}])",
       "/limits: must be an angle"},
      {R"("joints": [{"kind": "weld", "parts": ["a", "b"], "anchor": [0,0,0], "near": [[0,0,0]]}])",
       "/near: must"},
      {R"("joints": [{"kind": "weld", "parts": ["a", "b"], "anchor": [0,0,0], "radius": -1}])",
       "/radius: must"}};
  for (const auto& [members, message] : bad) {
    const auto scene = described(members);
    ASSERT_FALSE(scene.ok()) << members;
    EXPECT_NE(scene.error().message.find(message), std::string::npos) << scene.error().message;
  }
}

TEST(JointDescriptions, parts_are_objects_and_groups_of_the_mesh) {
  const auto scene = loaded(kHinge);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  ASSERT_EQ(scene->world.joints().all.size(), 1u);
  const Joint& joint = scene->world.joints().all[0];
  EXPECT_EQ(joint.kind, Joint::Kind::kHinge);
  EXPECT_EQ(joint.body, (BodyId{0, 0}));
  EXPECT_EQ(joint.sides[0].faces, std::vector<uint32_t>{0});
  EXPECT_EQ(joint.sides[1].faces, std::vector<uint32_t>{1});
  EXPECT_EQ(joint.axis, Vec3(0, 1, 0));
  EXPECT_NEAR(joint.limits->low, -0.17453292519943295, 1e-15);
  EXPECT_NEAR(joint.limits->high, 1.5707963267948966, 1e-15);
}

TEST(JointDescriptions, the_length_of_an_axis_is_ignored) {
  for (const char* axis : {"[0, 1e-300, 0]", "[0, 1e300, 0]"}) {
    const auto scene = loaded(std::string(R"("joints": [{"kind": "hub", "parts": ["door", "frame"],
      "anchor": [0, 0, 0], "axis": )") +
                              axis + "}]");
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(scene->world.joints().all[0].axis, Vec3(0, 1, 0));
  }
}

// A strip of two triangles that hang together and a third one above them, and a post.
TEST(JointDescriptions, connected_faces_around_the_nearest_one_carry_a_joint) {
  constexpr const char* kStrip =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 5 0 0\nv 6 0 0\nv 5 1 0\n"
      "o strip\nf 1 2 3\nf 2 4 3\nf 5 6 7\no post\nf 8 9 10\n";
  struct Case {
    const char* members;
    std::vector<uint32_t> carry;
  };
  for (const auto& [members, carry] : {Case{"", {0, 1}}, Case{R"(, "near": [[0, 0, 1], [5, 0, 0]])", {2}},
                                       Case{R"(, "near": [[0, 0, 0], [5, 0, 0]], "radius": 0.5)", {0}},
                                       Case{R"(, "near": [[1, 1, 0.4], [5, 0, 0]], "radius": 0.7)", {1}}}) {
    const auto scene =
        loaded(std::string(R"("joints": [{"kind": "weld", "parts": ["strip", "post"], "anchor": [0, 0, 0])") +
                   members + "}]",
               kStrip);
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    const Joint& joint = scene->world.joints().all[0];
    EXPECT_EQ(joint.sides[0].faces, carry) << members;
    EXPECT_EQ(joint.sides[1].faces, std::vector<uint32_t>{3}) << members;
  }
}

TEST(JointDescriptions, a_joint_that_does_not_fit_the_mesh_is_an_error) {
  const std::pair<const char*, const char*> bad[]{
      {R"({"kind": "weld", "parts": ["door", "roof"], "anchor": [0,0,0]})", "no part named \"roof\""},
      {R"({"kind": "weld", "parts": ["door", "frame"], "anchor": [0,0,0.5], "radius": 0.4})",
       "within its radius"},
      {R"({"kind": "weld", "parts": ["door", "frame"], "anchor": [1e300,0,0]})", "too far"},
      {R"({"kind": "weld", "parts": ["steel", "frame"], "anchor": [0,0,0]})", "a face carries both sides"}};
  for (const auto& [joint, message] : bad) {
    const auto scene = loaded(std::string(R"("joints": [)") + joint + "]");
    ASSERT_FALSE(scene.ok()) << joint;
    EXPECT_NE(scene.error().message.find(message), std::string::npos) << scene.error().message;
    EXPECT_EQ(scene.error().code, ErrorCode::kBadInput);
  }
}

}  // namespace
}  // namespace kerf
