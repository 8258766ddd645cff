#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/base/random.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/gltf_file_internal.h"
#include "core/mesh/files/readers.h"
#include "core/mesh/mesh_file.h"

// Tangents and custom attributes.
namespace kerf::test {
namespace {

std::vector<glm::vec4> corner_values(const LookChannel<glm::vec4>& channel) {
  std::vector<glm::vec4> all;
  for (const auto& corners : channel.corners) {
    for (const uint32_t v : corners) all.push_back(channel.values.at(v));
  }
  return all;
}

const std::string kPlyHead =
    "element vertex 3\nproperty float x\nproperty int label\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty double quality\nproperty list uchar int seen\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n";

void expect_quality_and_label(const Result<Soup>& soup) {
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  ASSERT_EQ(soup->looks.attributes.size(), 3u);
  EXPECT_EQ(soup->looks.attributes[0].name, "label");
  EXPECT_EQ(soup->looks.attributes[1].name, "red");  // there is no green
  EXPECT_EQ(soup->looks.attributes[2].name, "quality");
  const std::vector<glm::vec4> labels{{7, 0, 0, 0}, {-8, 0, 0, 0}, {9, 0, 0, 0}};
  const std::vector<glm::vec4> qualities{{0.5f, 0, 0, 0}, {0.25f, 0, 0, 0}, {1, 0, 0, 0}};
  EXPECT_EQ(corner_values(soup->looks.attributes[0].channel), labels);
  EXPECT_EQ(corner_values(soup->looks.attributes[2].channel), qualities);
  EXPECT_FALSE(soup->looks.normals.any());
}

TEST(AttributesOfPly, are_the_other_scalars_of_vertices) {
  expect_quality_and_label(read_ply(
      "ply\nformat ascii 1.0\n" + kPlyHead + "0 7 0 0 1 0.5 0\n1 -8 0 0 2 0.25 1 4\n0 9 1 0 3 1 0\n3 0 1 2\n",
      "a.ply"));
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + kPlyHead;
  bytes.replace(bytes.find("property list uchar int seen\n"), 29, "");
  const auto add = [&](float x, int label, float y, uint8_t red, double quality) {
    append_little(x, bytes);
    append_little(label, bytes);
    append_little(y, bytes);
    append_little(0.0f, bytes);
    append_little(red, bytes);
    append_little(quality, bytes);
  };
  add(0, 7, 0, 1, 0.5);
  add(1, -8, 0, 2, 0.25);
  add(0, 9, 1, 3, 1);
  bytes += '\3';
  for (const int v : {0, 1, 2}) append_little(v, bytes);
  expect_quality_and_label(read_ply(bytes, "a.ply"));
}

TEST(AttributesOfPly, have_a_limit) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  for (int i = 0; i < 20; ++i) text += "property float a" + std::to_string(i) + "\n";
  text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const char* position : {"0 0 0", "1 0 0", "0 1 0"}) {
    text += position;
    for (int i = 0; i < 20; ++i) text += " 1";
    text += "\n";
  }
  const auto soup = read_ply(text + "3 0 1 2\n", "a.ply");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  EXPECT_EQ(soup->looks.attributes.size(), kMaxLookAttributes);
  EXPECT_EQ(soup->warnings,
            std::vector<std::string>{"4 properties of vertices beyond the limit of 16 were ignored."});
}

TEST(AttributesOfPly, that_are_not_finite_numbers_are_named_in_a_note) {
  const auto built = build_mesh(*read_ply(
      "ply\nformat ascii 1.0\n" + kPlyHead + "0 7 0 0 1 nan 0\n1 -8 0 0 2 0.25 0\n0 9 1 0 3 1 0\n3 0 1 2\n",
      "a.ply"));
  ASSERT_TRUE(built.ok()) << built.error().message;
  EXPECT_EQ(built->report.warnings,
            std::vector<std::string>{
                "1 face has values of attribute 'quality' that are not finite numbers and loses them."});
}

struct AttributeSample {
  Soup soup;
  MeshView view() const { return {soup.positions, soup.triangles, {}, {}, {}, {}, {}, &soup.looks}; }
};

AttributeSample random_attributes(Random& random) {
  AttributeSample sample;
  Soup& soup = sample.soup;
  const auto number = [&] { return static_cast<float>(random.uniform(-1, 1)); };
  const auto corners = [&](uint64_t count) {
    return std::array<uint32_t, 3>{static_cast<uint32_t>(random.below(count)),
                                   static_cast<uint32_t>(random.below(count)),
                                   static_cast<uint32_t>(random.below(count))};
  };
  CornerLooks& looks = soup.looks;
  looks.v_points_down = true;
  looks.uv_sets.resize(1);
  looks.attributes = {{"TEMPERATURE", 1, {}}, {"x", 3, {}}, {"wind speed", 4, {}}};
  for (int i = 0; i < 20; ++i) {
    soup.positions.emplace_back(number(), number(), number());
    looks.uv_sets[0].values.emplace_back(number(), number());
    looks.normals.values.push_back(glm::normalize(glm::vec3(number(), number(), number())));
    looks.tangents.values.emplace_back(glm::normalize(glm::vec3(number(), number(), number())),
                                       random.below(2) == 0 ? 1 : -1);
    for (LookAttribute& attribute : looks.attributes) {
      glm::vec4 value(0);
      for (int k = 0; k < attribute.parts; ++k) value[k] = number();
      attribute.channel.values.push_back(value);
    }
  }
  for (int t = 0; t < 40; ++t) {
    soup.triangles.push_back(corners(20));
    looks.uv_sets[0].corners.push_back(corners(20));
    looks.normals.corners.push_back(corners(20));
    looks.tangents.corners.push_back(corners(20));
    for (LookAttribute& attribute : looks.attributes) attribute.channel.corners.push_back(corners(20));
  }
  return sample;
}

const LookAttribute* find(const Soup& soup, const std::string& name) {
  for (const LookAttribute& attribute : soup.looks.attributes) {
    if (attribute.name == name) return &attribute;
  }
  return nullptr;
}

TEST(Attributes, come_back_from_gltf_and_ply) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const AttributeSample sample = random_attributes(random);
    const auto gltf = read_gltf(encoded(sample.view(), MeshFormat::kGlb), "a.glb");
    ASSERT_TRUE(gltf.ok()) << gltf.error().message;
    EXPECT_EQ(gltf->warnings, std::vector<std::string>{});
    const auto tangents = corner_values(gltf->looks.tangents),
               wanted = corner_values(sample.soup.looks.tangents);
    ASSERT_EQ(tangents.size(), wanted.size());
    for (size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_LT(glm::distance(glm::vec3(tangents[i]), glm::vec3(wanted[i])), 1e-6f);
      EXPECT_EQ(tangents[i].w, wanted[i].w);
    }
    ASSERT_EQ(gltf->looks.attributes.size(), 3u);
    for (const LookAttribute& attribute : sample.soup.looks.attributes) {
      const LookAttribute* const back = find(*gltf, attribute.name);
      ASSERT_NE(back, nullptr);
      EXPECT_EQ(back->parts, attribute.parts);
      EXPECT_EQ(corner_values(back->channel), corner_values(attribute.channel));
    }
    const auto ply = read_ply(encoded(sample.view(), MeshFormat::kPly), "a.ply");
    ASSERT_TRUE(ply.ok()) << ply.error().message;
    ASSERT_EQ(ply->looks.attributes.size(), 8u);
    EXPECT_EQ(corner_values(ply->looks.attributes[0].channel),
              corner_values(sample.soup.looks.attributes[0].channel));
    for (int k = 0; k < 3; ++k) {
      const LookAttribute* const back = find(*ply, std::string("x_") + "xyz"[k]);
      ASSERT_NE(back, nullptr);
      const auto values = corner_values(back->channel),
                 all = corner_values(sample.soup.looks.attributes[1].channel);
      for (size_t i = 0; i < all.size(); ++i) EXPECT_EQ(values[i].x, all[i][k]);
    }
    EXPECT_NE(find(*ply, "wind_speed_w"), nullptr);
  }
}

TEST(Attributes, of_ply_need_no_normals_and_do_not_take_names) {
  AttributeSample sample;
  sample.soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  sample.soup.triangles = {{0, 1, 2}, {2, 1, 3}};
  sample.soup.looks.attributes = {{"x", 1, {{{1, 0, 0, 0}, {2, 0, 0, 0}, {3, 0, 0, 0}, {4, 0, 0, 0}}, {}}}};
  sample.soup.looks.attributes[0].channel.corners = sample.soup.triangles;
  const std::string bytes = encoded(sample.view(), MeshFormat::kPly);
  EXPECT_EQ(bytes.find("nx"), std::string::npos);
  const auto ply = read_ply(bytes, "a.ply");
  ASSERT_TRUE(ply.ok()) << ply.error().message;
  EXPECT_EQ(ply->positions, sample.soup.positions);
  ASSERT_EQ(ply->looks.attributes.size(), 1u);
  EXPECT_EQ(ply->looks.attributes[0].name, "_x");
}

// Adds an attribute whose numbers are all its index.
void add_attribute(const std::string& name, uint8_t parts, Soup& soup) {
  const auto index = static_cast<float>(soup.looks.attributes.size());
  glm::vec4 value(0);
  for (int k = 0; k < parts; ++k) value[k] = index;
  LookChannel<glm::vec4> channel{{value}, {}};
  channel.corners.assign(soup.triangles.size(), {0, 0, 0});
  soup.looks.attributes.push_back({name, parts, std::move(channel)});
}

AttributeSample one_triangle() {
  AttributeSample sample;
  sample.soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sample.soup.triangles = {{0, 1, 2}};
  return sample;
}

std::string names_and_numbers(const Result<Soup>& soup) {
  if (!soup.ok()) return soup.error().message;
  std::map<std::string, float> numbers;
  for (const LookAttribute& attribute : soup->looks.attributes)
    numbers[attribute.name] = corner_values(attribute.channel).at(0).x;
  std::string text;
  for (const auto& [name, number] : numbers)
    text += name + "=" + std::to_string(static_cast<int>(number)) + " ";
  return text;
}

TEST(Attributes, whose_names_are_equal_in_a_file_get_numbers) {
  AttributeSample sample = one_triangle();
  for (const char* name : {"a b", "a_b", "x", "_x", "v_x", "q", "q", "q_2", "\xff", "\xfe"})
    add_attribute(name, 1, sample.soup);
  add_attribute("v", 2, sample.soup);
  EXPECT_EQ(names_and_numbers(read_ply(encoded(sample.view(), MeshFormat::kPly), "a.ply")),
            "_x=2 _x_2=3 a_b=0 a_b_2=1 q=5 q_2=7 q_3=6 v_x=4 v_x_2=10 v_y=10 \xfe=9 \xff=8 ");
  EXPECT_EQ(names_and_numbers(read_gltf(encoded(sample.view(), MeshFormat::kGltf), "a.gltf")),
            "_x=3 a b=0 a_b=1 q=5 q_2=7 q_3=6 v=10 v_x=4 x=2 \xef\xbf\xbd=8 \xef\xbf\xbd_2=9 ");
}

TEST(Attributes, of_gltf_are_those_of_each_key) {
  AttributeSample sample = one_triangle();
  for (const char* name : {"a?b", "c"}) add_attribute(name, 1, sample.soup);
  auto file = nlohmann::json::parse(encoded(sample.view(), MeshFormat::kGltf));
  nlohmann::json& attributes = file["meshes"][0]["primitives"][0]["attributes"];
  attributes["_a\tb"] = attributes["_c"];
  attributes.erase("_c");
  const auto soup = read_gltf(file.dump(), "a.gltf");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  ASSERT_EQ(soup->looks.attributes.size(), 2u);
  for (const LookAttribute& attribute : soup->looks.attributes) EXPECT_EQ(attribute.name, "a?b");
  EXPECT_EQ(corner_values(soup->looks.attributes[0].channel).at(0).x, 1);
  EXPECT_EQ(corner_values(soup->looks.attributes[1].channel).at(0).x, 0);
}

TEST(NormalsOfGltf, have_unit_length) {
  AttributeSample sample = one_triangle();
  sample.soup.looks.normals = {{{0, 0, 5}}, {{0, 0, 0}}};
  const std::string bytes = encoded(sample.view(), MeshFormat::kGlb);
  const auto has_normal = [&](float z) {
    std::string normal;
    for (const float number : {0.0f, 0.0f, z}) append_little(number, normal);
    return bytes.find(normal) != std::string::npos;
  };
  EXPECT_FALSE(has_normal(5));
  EXPECT_TRUE(has_normal(1));
}

// A mirroring transform reverses the sign of the bitangent, so that cross(normal, tangent) * sign is the
// transformed bitangent.
TEST(TangentsOfGltf, keep_the_bitangent_under_transforms) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    AttributeSample sample;
    sample.soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    sample.soup.triangles = {{0, 1, 2}};
    CornerLooks& looks = sample.soup.looks;
    looks.normals = {{{0, 0, 1}}, {{0, 0, 0}}};
    const float sign = random.below(2) == 0 ? 1 : -1;
    looks.tangents = {{{1, 0, 0, sign}}, {{0, 0, 0}}};
    auto file = nlohmann::json::parse(encoded(sample.view(), MeshFormat::kGltf));
    std::array<double, 3> scale{};
    for (double& s : scale) s = random.uniform(0.5, 2) * (random.below(2) == 0 ? 1 : -1);
    file["nodes"][0]["scale"] = scale;
    const auto soup = read_gltf(file.dump(), "a.gltf");
    ASSERT_TRUE(soup.ok()) << soup.error().message;
    const Vec3 n(soup->looks.normals.values[0]);
    const glm::dvec4 t(soup->looks.tangents.values[0]);
    EXPECT_EQ(Vec3(t), Vec3(scale[0] < 0 ? -1 : 1, 0, 0));
    const Vec3 bitangent = glm::cross(n, Vec3(t)) * t.w;
    EXPECT_EQ(bitangent.y, sign * (scale[1] < 0 ? -1 : 1));
  }
}

}  // namespace
}  // namespace kerf::test
