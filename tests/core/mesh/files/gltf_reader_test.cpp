#include "core/base/json.h"
#include "core/mesh/files/readers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/base/random.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/gltf_file_internal.h"
#include "tests/core/mesh/files/sample_files.h"

namespace kerf::test {
namespace {

using nlohmann::json;

// A square in the plane z = 0, as four positions and six indices.
std::string square_buffer() {
  std::string bytes;
  for (const auto& [x, y] : {std::pair(0.0f, 0.0f), {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
    append_little(x, bytes);
    append_little(y, bytes);
    append_little(0.0f, bytes);
  }
  for (const int i : {0, 1, 2, 0, 2, 3}) append_little(static_cast<uint16_t>(i), bytes);
  return bytes;
}

json square(const std::string& uri = "data:;base64," + to_base64(square_buffer())) {
  return json::parse(
      R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
    "buffers": [{"byteLength": 60, "uri": ")" +
      uri + R"("}]})");
}

Soup soup_of(const json& file) {
  auto soup = read_gltf(file.dump(), "a.gltf");
  EXPECT_TRUE(soup.ok()) << soup.error().message;
  return soup.ok() ? std::move(*soup) : Soup();
}

std::string refusal_of(const json& file, const std::filesystem::path& folder = {}) {
  const auto soup = read_gltf(file.dump(), "a.gltf", nullptr, folder);
  EXPECT_FALSE(soup.ok());
  return soup.ok() ? "" : soup.error().message;
}

double signed_area_xy(const Soup& soup) {
  double twice = 0;
  for (const auto& [a, b, c] : soup.triangles) {
    const Vec3 u = soup.positions[b] - soup.positions[a], v = soup.positions[c] - soup.positions[a];
    twice += u.x * v.y - u.y * v.x;
  }
  return twice / 2;
}

TEST(Gltf, node_transforms_apply_to_their_meshes) {
  json file = square();
  file["scenes"][0]["nodes"] = {0, 1};
  file["nodes"] = json::parse(R"([{"mesh": 0, "name": "a", "translation": [0, 0, 2]},
    {"mesh": 0, "name": "b", "scale": [3, 3, 3], "children": [2]},
    {"mesh": 0, "name": "c", "translation": [5, 0, 0], "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]}])");
  const Soup soup = soup_of(file);
  EXPECT_EQ(soup.format, "gltf");
  EXPECT_EQ(soup.triangles.size(), 6u);
  EXPECT_NEAR(area(soup), 1 + 9 + 9, 1e-12);
  EXPECT_EQ(soup.positions[0].z, 2);
  // The third square is rotated by a quarter turn about its corner at (15, 0).
  EXPECT_NEAR(glm::length(soup.positions[9] - Vec3(15, 3, 0)), 0, 1e-12);
  ASSERT_EQ(soup.parts.size(), 3u);
  EXPECT_EQ(soup.parts[2].name, "c");
  EXPECT_EQ(soup.parts[2].first, 4u);
}

TEST(Gltf, a_mirroring_matrix_flips_faces) {
  json file = square();
  file["nodes"][0]["matrix"] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_NEAR(signed_area_xy(soup_of(file)), 1, 1e-12);
  EXPECT_NEAR(signed_area_xy(soup_of(square())), 1, 1e-12);
}

TEST(Gltf, reads_strips_fans_and_meshes_without_indices) {
  json file = square();
  json& primitive = file["meshes"][0]["primitives"][0];
  primitive.erase("indices");
  primitive["mode"] = 6;
  EXPECT_NEAR(signed_area_xy(soup_of(file)), 1, 1e-12);
  primitive["mode"] = 4;  // the fourth position begins no triangle
  EXPECT_EQ(soup_of(file).triangles.size(), 1u);
  primitive["mode"] = 5;  // over the corners 0 1 2 3 the strip covers 0 1 2 and 1 3 2
  const Soup strip = soup_of(file);
  EXPECT_EQ(strip.triangles, (std::vector<Soup::Triangle>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(Gltf, reads_material_names_and_skips_points) {
  json file = square();
  file["materials"] = json::parse(R"([{"name": "red"}, {}])");
  json& primitives = file["meshes"][0]["primitives"];
  primitives[0]["material"] = 1;
  primitives.push_back(primitives[0]);
  primitives[1]["material"] = 0;
  primitives.push_back(primitives[0]);
  primitives[2]["mode"] = 1;
  const Soup soup = soup_of(file);
  EXPECT_EQ(soup.material_names, (std::vector<std::string>{"material 1", "red"}));
  EXPECT_EQ(soup.materials, (std::vector<uint16_t>{0, 0, 1, 1}));
  EXPECT_EQ(soup.positions.size(), 4u);  // shared by the primitives
  EXPECT_EQ(soup.warnings.size(), 1u);
}

TEST(Gltf, reports_sets_and_variants_that_are_not_read) {
  json file = square();
  json& primitive = file["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_4"] = 0;
  primitive["attributes"]["COLOR_1"] = 0;
  primitive["attributes"]["JOINTS_0"] = 0;
  primitive["extensions"] = {{"KHR_materials_variants", {{"mappings", json::array()}}}};
  file["meshes"][0]["primitives"].push_back(primitive);
  EXPECT_EQ(soup_of(file).warnings,
            (std::vector<std::string>{"Vertex colours beyond the first set were ignored.",
                                      "UVs beyond the fourth set were ignored.",
                                      "Variants of materials were ignored."}));
  EXPECT_TRUE(soup_of(square()).warnings.empty());
}

TEST(Gltf, reports_scenes_that_are_not_read) {
  json file = square();
  file["nodes"].push_back(json::parse(R"({"mesh": 0, "name": "other"})"));
  file["scenes"].push_back(json::parse(R"({"nodes": [1]})"));
  file["scene"] = 1;
  const Soup soup = soup_of(file);
  ASSERT_EQ(soup.parts.size(), 1u);
  EXPECT_EQ(soup.parts[0].name, "other");
  EXPECT_EQ(soup.warnings, std::vector<std::string>{"Only one of 2 scenes was read, the default one."});
  file.erase("scene");
  EXPECT_EQ(soup_of(file).warnings,
            std::vector<std::string>{"Only one of 2 scenes was read, the first one."});
}

TEST(Gltf, is_fast_for_many_nodes_with_many_primitives_without_triangles) {
  constexpr int kMany = 20'000;
  json file = square();
  json& primitives = file["meshes"][0]["primitives"];
  const json points = {{"attributes", {{"POSITION", 0}}}, {"mode", 0}};
  for (int i = 0; i < kMany; ++i) primitives.push_back(points);
  for (int i = 1; i < kMany; ++i) {
    file["nodes"].push_back({{"mesh", 0}});
    file["scenes"][0]["nodes"].push_back(i);
  }
  const Soup soup = soup_of(file);
  EXPECT_EQ(soup.triangles.size(), 2u * kMany);
  EXPECT_EQ(soup.parts.size(), size_t{kMany});
}

TEST(Gltf, an_index_out_of_range_is_an_invalid_face) {
  json file = square();
  file["accessors"][0]["count"] = 3;
  const Soup soup = soup_of(file);
  EXPECT_EQ(soup.triangles.size(), 1u);
  EXPECT_EQ(soup.invalid_faces_dropped, 1u);
}

TEST(Gltf, reads_buffers_next_to_the_file_or_in_subfolders) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "in a");
  std::ofstream(folder / "in a/x.bin", std::ios::binary) << square_buffer();
  const auto read = read_gltf(square("in%20a/x.bin").dump(), "a.gltf", nullptr, folder.path());
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->triangles.size(), 2u);
  const std::string name = folder.path().filename().string();
  for (const std::string& uri : std::vector<std::string>{
           "in%20a/y.bin", "../" + name + "/in%20a/x.bin", (folder / "in a/x.bin").string(), "%2e%2e/x.bin",
           "https://example.org/x.bin", "in%2", "", "data:;base64,?"}) {
    EXPECT_TRUE(
        is_one_line_about(Error{ErrorCode::kBadInput, refusal_of(square(uri), folder.path())}, "a.gltf: "))
        << uri;
  }
  refusal_of(square("in%20a/x.bin"));  // without a folder no file is read
}

TEST(Gltf, unsupported_content_is_named) {
  const auto with = [](const char* pointer, const json& value) {
    json file = square();
    file[json::json_pointer(pointer)] = value;
    return refusal_of(file);
  };
  const auto expect_contains = [](const std::string& message, const char* word) {
    EXPECT_NE(message.find(word), std::string::npos) << message;
    EXPECT_TRUE(is_one_line_about(Error{ErrorCode::kBadInput, message}, "a.gltf: ")) << message;
  };
  expect_contains(with("/extensionsRequired", {"KHR_draco_mesh_compression"}), "KHR_draco_mesh_compression");
  expect_contains(with("/extensionsRequired", {"EXT_meshopt_compression"}), "EXT_meshopt_compression");
  expect_contains(with("/accessors/0/sparse", json::object()), "sparse");
  expect_contains(with("/accessors/0/componentType", 5125), "componentType");
  expect_contains(with("/asset/version", "1.0"),
                  "this is glTF 1.0, but only glTF 2.0 is supported; convert it to 2.0");
  expect_contains(with("/asset/version", 1), "this is glTF 1,");
  expect_contains(with("/asset/minVersion", "2.1"), "this is glTF 2.1,");
  const json named = {{"a", json::object()}};
  expect_contains(refusal_of({{"asset", {{"version", "1.0"}}}, {"accessors", named}, {"meshes", named}}),
                  "glTF 1.0");
  expect_contains(refusal_of({{"asset", json::object()}, {"accessors", named}, {"meshes", named}}),
                  "glTF 1.0");
  expect_contains(with("/nodes/0/children", {0}), "ancestor");
  expect_contains(with("/accessors/1/count", 7), "cannot hold");
  expect_contains(with("/accessors/1/count", uint64_t{1} << 52), "cannot hold");
  expect_contains(with("/bufferViews/0/byteLength", 61), "reaches to byte 61");
  expect_contains(with("/bufferViews/0/byteStride", 4), "byteStride");
  expect_contains(with("/buffers/0/byteLength", 61), "declares 61 bytes");
  expect_contains(with("/nodes/0/mesh", 1), "which has 1");
  expect_contains(with("/nodes/0/scale", {1, 1}), "3 finite numbers");
  json skinned = square();
  skinned["nodes"][0]["skin"] = 0;
  EXPECT_EQ(soup_of(skinned).warnings.size(), 1u);
  json looks = square();
  looks["extensionsRequired"] = {"KHR_materials_unlit"};
  EXPECT_EQ(soup_of(looks).triangles.size(), 2u);
}

TEST(Gltf, written_files_round_trip_at_any_position) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Vec3 far(random.uniform(-1e6, 1e6), random.uniform(-1e6, 1e6), 0);
    std::vector<Vec3> positions;
    for (int i = 0; i < 30; ++i)
      positions.push_back(far + Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    std::vector<std::array<uint32_t, 3>> triangles;
    std::vector<uint16_t> materials;
    for (int i = 0; i < 40; ++i) {
      const auto corner = [&] { return static_cast<uint32_t>(random.below(positions.size())); };
      triangles.push_back({corner(), corner(), corner()});
      materials.push_back(static_cast<uint16_t>(i / 20));
    }
    const std::vector<std::string> names{"red", "blue"};
    const MeshView view{positions, triangles, materials, names, {}, "piece"};
    for (const MeshFormat format : {MeshFormat::kGlb, MeshFormat::kGltf}) {
      const auto soup = read_gltf(encoded(view, format), "a");
      ASSERT_TRUE(soup.ok()) << soup.error().message;
      EXPECT_EQ(soup->triangles, triangles);
      EXPECT_EQ(soup->materials, materials);
      EXPECT_EQ(soup->material_names, names);
      ASSERT_EQ(soup->parts.size(), 1u);
      EXPECT_EQ(soup->parts[0].name, "piece");
      for (size_t i = 0; i < positions.size(); ++i)
        EXPECT_LT(glm::length(soup->positions[i] - positions[i]), 3e-7) << i;
    }
  }
}

TEST(Gltf, a_written_hull_is_read_back_after_its_mesh) {
  const std::vector<Vec3> positions{{5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}};
  const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}, {0, 2, 3}};
  NodeCollider collider;
  collider.name = "piece hull";
  collider.positions = {{5, 0, -1}, {6, 0, -1}, {5.5, 1, -1}, {5.5, 0.5, 1}};
  collider.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  MeshView view{positions, triangles, {}, {}};
  view.collider = &collider;
  for (const MeshFormat format : {MeshFormat::kGlb, MeshFormat::kGltf}) {
    const auto soup = read_gltf(encoded(view, format), "a");
    ASSERT_TRUE(soup.ok()) << soup.error().message;
    ASSERT_EQ(soup->triangles.size(), 6u);
    for (size_t t = 0; t < 6; ++t) {
      for (size_t i = 0; i < 3; ++i) {
        const Vec3& expected =
            t < 2 ? positions[triangles[t][i]] : collider.positions[collider.triangles[t - 2][i]];
        EXPECT_LT(glm::distance(soup->positions[soup->triangles[t][i]], expected), 1e-6);
      }
    }
  }
}

TEST(Base64, round_trips) {
  Random random(3);
  std::string bytes;
  for (int size = 0; size < 40; ++size) {
    EXPECT_EQ(from_base64(to_base64(bytes)), bytes);
    EXPECT_EQ(to_base64(bytes).size() % 4, 0u);
    bytes += static_cast<char>(random.below(256));
  }
  EXPECT_EQ(to_base64("Man"), "TWFu");
  EXPECT_EQ(to_base64("M"), "TQ==");
  for (const char* damaged : {"TWF", "T", "TW-u", "TWFu\n"})
    EXPECT_EQ(from_base64(damaged).has_value(), std::string(damaged) == "TWF");
}

}  // namespace
}  // namespace kerf::test
