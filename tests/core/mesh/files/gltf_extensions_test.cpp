#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <glm/gtc/quaternion.hpp>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/base/platform.h"
#include "core/base/random.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/gltf_file_internal.h"
#include "core/mesh/files/readers.h"
#include "tests/core/mesh/files/sample_files.h"

// Sparse accessors, KHR_mesh_quantization and EXT_mesh_gpu_instancing.
namespace kerf::test {
namespace {

using nlohmann::json;

// A glTF file whose accessors are added one by one.
struct GltfBuilder {
  json file{{"asset", {{"version", "2.0"}}}, {"accessors", json::array()}, {"bufferViews", json::array()}};
  std::string buffer;

  template <typename T>
  size_t add_view(const std::vector<T>& numbers, size_t stride = 0) {
    json view{{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", numbers.size() * sizeof(T)}};
    if (stride > 0) view["byteStride"] = stride;
    file["bufferViews"].push_back(view);
    for (const T number : numbers) append_little(number, buffer);
    buffer.append((4 - buffer.size() % 4) % 4, '\0');
    return file["bufferViews"].size() - 1;
  }
  size_t add(const json& accessor) {
    file["accessors"].push_back(accessor);
    return file["accessors"].size() - 1;
  }
  template <typename T>
  size_t add(const char* type, int component, size_t count, const std::vector<T>& numbers,
             bool normalised = false, size_t stride = 0) {
    json accessor{{"bufferView", add_view(numbers, stride)},
                  {"componentType", component},
                  {"count", count},
                  {"type", type}};
    if (normalised) accessor["normalized"] = true;
    return add(accessor);
  }
  void set_mesh(const json& attributes) {
    file["meshes"] = json::array({{{"primitives", json::array({{{"attributes", attributes}}})}}});
    file["nodes"] = json::array({{{"mesh", 0}, {"name", "tree"}}});
  }
  std::string text() {
    file["buffers"] = json::array({{{"byteLength", buffer.size()},
                                    {"uri", "data:application/octet-stream;base64," + to_base64(buffer)}}});
    return file.dump();
  }
  Soup read() {
    auto soup = read_gltf(text(), "a.gltf");
    EXPECT_TRUE(soup.ok()) << soup.error().message;
    return soup.ok() ? std::move(*soup) : Soup();
  }
  std::string refusal() {
    const auto soup = read_gltf(text(), "a.gltf");
    EXPECT_FALSE(soup.ok());
    if (soup) return "";
    EXPECT_TRUE(is_one_line_about(soup.error(), "a.gltf: ")) << soup.error().message;
    return soup.error().message;
  }
};

const std::vector<float> kCorners{0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST(GltfSparse, values_replace_those_of_the_buffer_view) {
  for (const bool has_view : {true, false}) {
    GltfBuilder gltf;
    json accessor{{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}};
    if (has_view) accessor["bufferView"] = gltf.add_view(kCorners);
    const size_t indices = gltf.add_view(std::vector<uint8_t>{1, 2});
    const size_t values = gltf.add_view(std::vector<float>{9, 9, 2, 0, 0, 0, 3, 0});
    accessor["sparse"] = {{"count", 2},
                          {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                          {"values", {{"bufferView", values}, {"byteOffset", 8}}}};
    gltf.set_mesh({{"POSITION", gltf.add(accessor)}});
    const Soup soup = gltf.read();
    EXPECT_EQ(soup.positions, (std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}));
  }
}

TEST(GltfSparse, damage_is_rejected) {
  const auto refusal = [](const char* pointer, const json& value) {
    GltfBuilder gltf;
    json accessor{
        {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}, {"bufferView", gltf.add_view(kCorners)}};
    accessor["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", gltf.add_view(std::vector<uint16_t>{2})}, {"componentType", 5123}}},
        {"values", {{"bufferView", gltf.add_view(std::vector<float>{7, 7, 7})}}}};
    accessor[json::json_pointer(pointer)] = value;
    gltf.set_mesh({{"POSITION", gltf.add(accessor)}});
    return gltf.refusal();
  };
  const auto expect_refusal = [&](const char* pointer, const json& value, const char* words) {
    const std::string message = refusal(pointer, value);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  expect_refusal("/count", 2, "has the number 2, but there are 2 elements");
  expect_refusal("/sparse", 7, "must be an object");
  expect_refusal("/sparse/count", 2, "cannot hold");
  expect_refusal("/sparse/count", uint64_t{1} << 52, "cannot hold");
  expect_refusal("/sparse/indices", 7, "componentType");
  expect_refusal("/sparse/indices/componentType", 5126, "componentType");
  expect_refusal("/sparse/indices/bufferView", 9, "which has 3");
  expect_refusal("/sparse/values/byteOffset", 4, "cannot hold");
  expect_refusal("/sparse/values/byteOffset", uint64_t{1} << 52, "cannot hold");
  expect_refusal("/sparse/values", json::object(), "/values/bufferView: is missing");
  GltfBuilder zeros;
  zeros.set_mesh({{"POSITION", zeros.add({{"componentType", 5126},
                                          {"count", uint64_t{1} << 40},
                                          {"type", "VEC3"},
                                          {"sparse", json::object()}})}});
  EXPECT_NE(zeros.refusal().find("more elements than the buffers"), std::string::npos);
}

// Corners and looks in one type of numbers: a right triangle of the given size, padded to rows of four.
template <typename T>
Soup quantised(int component, bool normalised, T size) {
  GltfBuilder gltf;
  gltf.file["extensionsRequired"] = {"KHR_mesh_quantization"};
  const T full = std::numeric_limits<T>::max();
  const T z = std::is_signed_v<T> ? full : T(0);
  gltf.set_mesh(
      {{"POSITION", gltf.add<T>("VEC3", component, 3, {0, 0, 0, 9, size, 0, 0, 9, 0, size, 0, 9}, normalised,
                                4 * sizeof(T))},
       {"TEXCOORD_0", gltf.add<T>("VEC2", component, 3, {0, full, 0, 0, full, 0, 0, 0, 0, size, 0, 0},
                                  normalised, 4 * sizeof(T))}});
  if constexpr (std::is_signed_v<T>) {
    gltf.file["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = gltf.add<T>(
        "VEC3", component, 3, {0, 0, z, 0, T(-full - 1), 0, 0, 0, 0, 0, z, 0}, true, 4 * sizeof(T));
  }
  return gltf.read();
}

template <typename T>
void expect_quantised(int component) {
  const T full = std::numeric_limits<T>::max(), size = T(full / 2);
  for (const bool normalised : {false, true}) {
    const Soup soup = quantised<T>(component, normalised, size);
    const double scale = normalised ? 1.0 / full : 1;
    ASSERT_EQ(soup.positions.size(), 3u);
    EXPECT_EQ(soup.positions[1], Vec3(size * scale, 0, 0));
    EXPECT_EQ(soup.positions[2], Vec3(0, size * scale, 0));
    ASSERT_EQ(soup.looks.uv_sets.size(), 1u);
    const auto& uvs = soup.looks.uv_sets[0].values;
    EXPECT_EQ(uvs[0], glm::vec2(glm::dvec2(0, full * scale)));
    EXPECT_EQ(uvs[2], glm::vec2(glm::dvec2(0, size * scale)));
    if (!std::is_signed_v<T>) continue;
    EXPECT_EQ(soup.looks.normals.values[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(soup.looks.normals.values[1], glm::vec3(-1, 0, 0));
  }
}

TEST(GltfQuantization, reads_all_types) {
  expect_quantised<int8_t>(5120);
  expect_quantised<uint8_t>(5121);
  expect_quantised<int16_t>(5122);
  expect_quantised<uint16_t>(5123);
}

// Random instances under a random node: each is a part at its place, with outward faces and right normals.
TEST(GltfInstances, become_parts_at_their_positions) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto number = [&] { return static_cast<float>(random.uniform(-2, 2)); };
    GltfBuilder gltf;
    gltf.file["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    gltf.set_mesh({{"POSITION", gltf.add("VEC3", 5126, 3, kCorners)},
                   {"NORMAL", gltf.add("VEC3", 5126, 3, std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1})}});
    const std::array<float, 3> node_scale{number(), number(), number()};
    gltf.file["nodes"][0]["scale"] = node_scale;
    std::vector<float> translations, rotations, scales;
    constexpr size_t kInstances = 8;
    for (size_t i = 0; i < kInstances; ++i) {
      for (int k = 0; k < 3; ++k) translations.push_back(number()), scales.push_back(number());
      for (int k = 0; k < 4; ++k) rotations.push_back(number());
    }
    gltf.file["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", gltf.add("VEC3", 5126, kInstances, translations)},
        {"ROTATION", gltf.add("VEC4", 5126, kInstances, rotations)},
        {"SCALE", gltf.add("VEC3", 5126, kInstances, scales)}};
    const Soup soup = gltf.read();
    ASSERT_EQ(soup.triangles.size(), kInstances);
    ASSERT_EQ(soup.parts.size(), kInstances);
    for (size_t i = 0; i < kInstances; ++i) {
      EXPECT_EQ(soup.parts[i].name, "tree");
      EXPECT_EQ(soup.parts[i].first, i);
      const auto three = [&](const std::vector<float>& from) {
        return Vec3(from[3 * i], from[3 * i + 1], from[3 * i + 2]);
      };
      const glm::dquat q(rotations[4 * i + 3], rotations[4 * i], rotations[4 * i + 1], rotations[4 * i + 2]);
      const auto placed = [&](const Vec3& p) {
        return Vec3(node_scale[0], node_scale[1], node_scale[2]) *
               (glm::normalize(q) * (three(scales) * p) + three(translations));
      };
      for (size_t c = 0; c < 3; ++c) {
        const Vec3 at(kCorners[3 * c], kCorners[3 * c + 1], kCorners[3 * c + 2]);
        EXPECT_LT(glm::distance(soup.positions[3 * i + c], placed(at)), 1e-12);
      }
      // A mirroring transform maps the outside of a closed mesh to the outside: inwards it is seen reversed.
      const auto& [a, b, c] = soup.triangles[i];
      const Vec3 across = glm::normalize(
          glm::cross(soup.positions[b] - soup.positions[a], soup.positions[c] - soup.positions[a]));
      const Vec3 beyond = placed(Vec3(0.3, 0.3, 1)) - placed(Vec3(0.3, 0.3, 0));
      EXPECT_GT(glm::dot(across, beyond), 0);
      const auto& corners = soup.looks.normals.corners[i];
      for (const uint32_t v : corners)
        EXPECT_LT(glm::distance(Vec3(soup.looks.normals.values[v]), across), 1e-6);
    }
  }
}

TEST(GltfInstances, damage_is_rejected) {
  const auto refusal = [](const auto& damage) {
    GltfBuilder gltf;
    gltf.set_mesh({{"POSITION", gltf.add("VEC3", 5126, 3, kCorners)}});
    json& attributes = gltf.file["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    attributes = {{"TRANSLATION", gltf.add("VEC3", 5126, 1, std::vector<float>{1, 2, 3})}};
    damage(gltf, attributes);
    return gltf.refusal();
  };
  const auto expect_refusal = [&](const char* words, const auto& damage) {
    const std::string message = refusal(damage);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  expect_refusal("has no TRANSLATION", [](GltfBuilder&, json& attributes) { attributes = json::object(); });
  expect_refusal("is missing", [](GltfBuilder&, json& attributes) { attributes = 7; });
  expect_refusal("which has 2", [](GltfBuilder&, json& attributes) { attributes["SCALE"] = 9; });
  expect_refusal("must be VEC4", [](GltfBuilder&, json& attributes) { attributes["ROTATION"] = 1; });
  expect_refusal("the same number of", [](GltfBuilder&, json& attributes) { attributes["SCALE"] = 0; });
  expect_refusal("the unusable instance 0", [](GltfBuilder& gltf, json& attributes) {
    attributes["ROTATION"] = gltf.add("VEC4", 5126, 1, std::vector<float>{0, 0, 0, 0});
  });
  expect_refusal("the unusable instance 0", [](GltfBuilder& gltf, json& attributes) {
    attributes["SCALE"] = gltf.add("VEC3", 5126, 1, std::vector<float>{1, INFINITY, 1});
  });
  expect_refusal("the maximum number of instances", [](GltfBuilder& gltf, json& attributes) {
    constexpr size_t kMany = 1'000'001;
    attributes["TRANSLATION"] = gltf.add("VEC3", 5120, kMany, std::vector<int8_t>(3 * kMany));
  });
  expect_refusal("without a buffer view", [](GltfBuilder& gltf, json& attributes) {
    attributes["SCALE"] =
        gltf.add({{"componentType", 5126}, {"count", 1}, {"type", "VEC3"}, {"sparse", json::object()}});
  });
}

// A sparse quantised square, twice, one of them mirrored; then with damage anywhere.
TEST(GltfInstances, of_sparse_quantized_meshes_survive_damage) {
  std::ifstream in(assets_folder().parent_path() / "tests/fuzz/corpus/gltf/instances.gltf");
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const auto soup = read_gltf(text, "a.gltf");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  EXPECT_EQ(soup->parts.size(), 2u);
  EXPECT_NEAR(area(*soup), 2, 1e-6);
  for (const auto& [a, b, c] : soup->triangles) {
    const Vec3 &p = soup->positions[a], &q = soup->positions[b], &r = soup->positions[c];
    EXPECT_GT(glm::cross(q - p, r - p).z, 0);
  }
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    Random random(seed);
    std::string damaged = text;
    for (uint64_t i = 0; i <= random.below(3); ++i)
      damaged[random.below(damaged.size())] = "0123456789,{}[]\":.-e"[random.below(21)];
    const auto read = read_gltf(damaged, "a.gltf");
    if (!read) EXPECT_TRUE(is_one_line_about(read.error(), "a.gltf: ")) << seed << read.error().message;
  }
}

}  // namespace
}  // namespace kerf::test
