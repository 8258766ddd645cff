#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/json.h"
#include "core/base/random.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/mtl_file.h"
#include "core/mesh/files/readers.h"
#include "core/mesh/files/surface_conversion.h"
#include "core/mesh/files/surface_look.h"
#include "core/mesh/mesh_file.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

const std::string kPng = "\x89PNG\r\n\x1a\n a painted image";

template <typename T>
std::vector<T> values_of(const LookChannel<T>& channel) {
  std::vector<T> all;
  for (const auto& corners : channel.corners) {
    for (const uint32_t v : corners)
      all.push_back(v == channel.kNone ? T(std::numeric_limits<float>::quiet_NaN()) : channel.values[v]);
  }
  return all;
}

template <typename T>
void expect_near(const LookChannel<T>& a, const LookChannel<T>& b, float error) {
  const auto one = values_of(a), other = values_of(b);
  ASSERT_EQ(one.size(), other.size());
  for (size_t i = 0; i < one.size(); ++i) {
    for (int k = 0; k < T::length(); ++k) ASSERT_NEAR(one[i][k], other[i][k], error) << i;
  }
}

TEST(LooksOfObj, have_values_per_corner) {
  const auto soup = read_obj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
      "f 1/1/1 2/2/1 3/3/1 4/4/1\nf -4/-1/-1 -2/3 -1//1\n",
      "a.obj");
  ASSERT_TRUE(soup.ok());
  ASSERT_EQ(soup->looks.uv_sets.size(), 1u);
  EXPECT_FALSE(soup->looks.v_points_down);
  const auto& uvs = soup->looks.uv_sets[0];
  ASSERT_EQ(uvs.corners.size(), 3u);
  for (size_t t = 0; t < 2; ++t) {
    for (size_t i = 0; i < 3; ++i) {
      const Vec3& p = soup->positions[soup->triangles[t][i]];
      EXPECT_EQ(uvs.values[uvs.corners[t][i]], glm::vec2(glm::dvec2(p.x, p.y)));
    }
  }
  EXPECT_EQ(uvs.corners[2], (std::array<uint32_t, 3>{3, 2, uvs.kNone}));
  EXPECT_EQ(soup->looks.normals.corners[2], (std::array<uint32_t, 3>{0, uvs.kNone, 0}));
  EXPECT_TRUE(soup->warnings.empty());
}

TEST(LooksOfObj, damaged_references_yield_a_warning) {
  const auto soup = read_obj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt one two\nvt 0\nvn 1 2\nf 1/1/1 2/2/1 3/9/1\nf 3/-3/1 2//2 1/2/\n",
      "a.obj");
  ASSERT_TRUE(soup.ok());
  ASSERT_EQ(soup->warnings.size(), 1u);
  EXPECT_EQ(soup->warnings[0], "3 corners refer to missing UVs or normals; their faces lose them.");
  const auto built = build_mesh(*soup);
  ASSERT_TRUE(built.ok());
  EXPECT_EQ(built->looks, nullptr);
}

TEST(LooksOfObj, of_faces_with_numbers_that_are_not_finite_are_left_out_with_a_note) {
  const auto notes = [](const std::string& faces) {
    const auto soup = read_obj(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nvt 0 1\nvt nan 0\nvn 0 0 nan\n" + faces, "a.obj");
    const auto built = build_mesh(*soup);
    EXPECT_TRUE(built.ok());
    return built->report.warnings;
  };
  const std::string good = "f 1/1 3/1 4/1\n", bad = "f 1/1 2/1 3/2\n", other = "f 3/2 2/1 5/1\n";
  EXPECT_EQ(notes(good), std::vector<std::string>{});
  const std::string both = "f 1/2/1 2/2/1 3/2/1\n";
  EXPECT_EQ(notes(good + bad),
            std::vector<std::string>{"1 face has UVs that are not finite numbers and loses them."});
  EXPECT_EQ(notes(good + bad + other),
            std::vector<std::string>{"2 faces have UVs that are not finite numbers and lose them."});
  EXPECT_EQ(notes(good + both), std::vector<std::string>{
                                    "1 face has UVs or normals that are not finite numbers and loses them."});
}

TEST(LooksOfObj, are_written_as_the_numbers_of_each_line) {
  const auto soup =
      read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0.5 0.25\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\n", "a.obj");
  ASSERT_TRUE(soup.ok());
  MeshView view{soup->positions, soup->triangles, {}, {}};
  view.looks = &soup->looks;
  EXPECT_EQ(encoded(view, MeshFormat::kObj),
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0.5 0.25\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\n");
}

TEST(LooksOfObj, are_written_for_the_corners_that_have_them) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0.5 0.25\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1 2 3\n"
      "f 1/1/1 2/1/1 3/1/1\n";
  const auto soup = read_obj(text, "a.obj");
  ASSERT_TRUE(soup.ok());
  MeshView view{soup->positions, soup->triangles, {}, {}};
  view.looks = &soup->looks;
  EXPECT_EQ(encoded(view, MeshFormat::kObj), text);
}

TEST(LooksOfObj, are_empty_without_attributes) {
  const auto soup = read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nvt 0 0\n", "a.obj");
  ASSERT_TRUE(soup.ok());
  EXPECT_FALSE(soup->looks.any());
  EXPECT_EQ(build_mesh(*soup)->looks, nullptr);
}

TEST(MtlFile, keeps_unknown_lines_and_finds_images) {
  const MtlFile file = parse_mtl(
      "# a comment\nKd 1 1 1\nnewmtl red paint\n  Kd 0.8 0.1 0.1\r\nwhat is this\nmap_Kd -s 2 2 1 -clamp on "
      "my "
      "paint.png\nmap_Bump -bm 0.5 bump.png\nmap_aat on\nnewmtl bare\nnorm -1.png\n");
  ASSERT_EQ(file.materials.size(), 2u);
  EXPECT_EQ(file.materials[0].name, "red paint");
  ASSERT_EQ(file.materials[0].lines.size(), 5u);
  EXPECT_EQ(file.materials[0].lines[1].text, "what is this");
  EXPECT_EQ(file.materials[0].lines[2].text, "map_Kd -s 2 2 1 -clamp on ");
  EXPECT_EQ(file.materials[0].lines[4].text, "map_aat on");
  EXPECT_EQ(file.references, (std::vector<std::string>{"my paint.png", "bump.png", "-1.png"}));
}

// The folder of a mesh with a library, an image in it, one outside and one that is missing.
struct PaintedFolder {
  TemporaryFolder folder;

  PaintedFolder() {
    std::filesystem::create_directories(folder / "mesh");
    write_text(folder / "secret.png", "secret");
    write_text(folder / "mesh/paint.png", kPng);
    write_text(folder / "mesh/a b.mtl",
               "newmtl red\nKd 0.8 0.1 0.1\nmap_Kd C:\\textures\\paint.png\nmap_Ks ../secret.png\nKs 1 1 1\n"
               "newmtl unused\nmap_Kd none.png\n");
    write_text(folder / "mesh/a.obj",
               "mtllib a b.mtl\no left fender\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
               "usemtl red\nf 1/1/1 2/2/1 3/3/1\nusemtl blue\nf 3/3/1 2/2/1 1/1/1\n");
  }
  Soup read() const { return *read_mesh(folder / "mesh/a.obj"); }
};

TEST(LooksOfObj, include_only_images_in_the_folder) {
  const PaintedFolder painted;
  const Soup soup = painted.read();
  ASSERT_NE(soup.surfaces, nullptr);
  ASSERT_EQ(soup.surfaces->images.size(), 2u);
  EXPECT_EQ(soup.surfaces->images[0].bytes, kPng);
  EXPECT_EQ(soup.surfaces->images[0].mime_type, "image/png");
  EXPECT_EQ(soup.surfaces->images[1].bytes, "");
  EXPECT_EQ(soup.warnings,
            (std::vector<std::string>{"The image '../secret.png' is not in the folder of this file.",
                                      "1 material is not in a material library."}));
}

TEST(LooksOfObj, include_images_in_the_folder_of_the_library) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "mesh/materials");
  write_text(folder / "mesh/car.obj",
             "mtllib materials/car.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl paint\nf 1 2 3\n");
  write_text(folder / "mesh/materials/car.mtl",
             "newmtl paint\nmap_Kd paint.png\nmap_Ke glow.png\nmap_Ks ../../secret.png\n");
  write_text(folder / "mesh/materials/paint.png", kPng);
  write_text(folder / "mesh/materials/glow.png", "of the library");
  write_text(folder / "mesh/glow.png", "of the mesh");
  write_text(folder / "secret.png", "secret");
  const auto soup = read_mesh(folder / "mesh/car.obj");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  ASSERT_EQ(soup->surfaces->images.size(), 3u);
  EXPECT_EQ(soup->surfaces->images[0].bytes, kPng);
  EXPECT_EQ(soup->surfaces->images[1].bytes, "of the mesh");
  EXPECT_EQ(soup->surfaces->images[2].bytes, "");
  EXPECT_EQ(soup->warnings,
            std::vector<std::string>{"The image '../../secret.png' is not in the folder of this file."});
  const auto files = files_of_obj(folder / "mesh/car.obj");
  EXPECT_NE(std::ranges::find(files, folder / "mesh/materials/paint.png"), files.end());
  EXPECT_EQ(std::ranges::find(files, folder / "secret.png"), files.end());
}

TEST(LooksOfGltf, round_trip_from_obj) {
  const PaintedFolder painted;
  const Soup soup = painted.read();
  const MeshView view{
      soup.positions, soup.triangles,     soup.materials, soup.material_names, {}, "left fender", {},
      &soup.looks,    soup.surfaces.get()};
  for (const MeshFormat format : {MeshFormat::kGlb, MeshFormat::kGltf}) {
    const std::string bytes = encoded(view, format);
    EXPECT_EQ(bytes.find(kPng) != std::string::npos, format == MeshFormat::kGlb);
    EXPECT_EQ(bytes.find("secret.png"), std::string::npos);
    const auto back = read_gltf(bytes, "a");
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_EQ(back->warnings, std::vector<std::string>{});
    EXPECT_EQ(back->material_names, soup.material_names);
    EXPECT_EQ(back->parts[0].name, "left fender");
    ASSERT_EQ(back->looks.uv_sets.size(), 1u);
    auto uvs = back->looks.uv_sets[0];
    for (glm::vec2& uv : uvs.values) uv.y = 1 - uv.y;
    expect_near(uvs, soup.looks.uv_sets[0], 1e-6f);
    expect_near(back->looks.normals, soup.looks.normals, 1e-6f);
    ASSERT_EQ(back->surfaces->images.size(), 1u);
    EXPECT_EQ(back->surfaces->images[0].bytes, kPng);
    const auto lines = mtl_lines(*back->surfaces, back->surfaces->materials[0]);
    const auto has = [&](const std::string& text) {
      return std::any_of(lines.begin(), lines.end(), [&](const MtlLine& line) { return line.text == text; });
    };
    EXPECT_TRUE(has("Kd 0.8 0.1 0.1"));
    EXPECT_TRUE(has("map_Kd "));
  }
}

TEST(LooksOfGltf, have_no_uvs_that_the_mesh_lacks) {
  const auto soup = read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n", "a.obj");
  ASSERT_TRUE(soup.ok());
  const MeshView view{soup->positions, soup->triangles, {}, {}, {}, {}, {}, &soup->looks};
  const auto file = nlohmann::json::parse(encoded(view, MeshFormat::kGltf));
  EXPECT_EQ(file["meshes"][0]["primitives"][0]["attributes"].size(), 2u) << "positions and normals";
  EXPECT_EQ(file["accessors"].size(), 3u);
  const auto back = read_gltf(file.dump(), "a.gltf");
  ASSERT_TRUE(back.ok()) << back.error().message;
  EXPECT_EQ(back->looks.uv_sets.size(), 0u);
  expect_near(back->looks.normals, soup->looks.normals, 0);
}

// Nor are vertices of faces with different planes separate.
TEST(LooksOfGltf, and_of_ply_have_no_normals_that_the_mesh_lacks) {
  const auto soup = read_obj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n",
      "a.obj");
  ASSERT_TRUE(soup.ok());
  CornerLooks looks = soup->looks;
  looks.tangents = {{{1, 0, 0, 1}}, {{0, 0, 0}, {0, 0, 0}}};
  const MeshView view{soup->positions, soup->triangles, {}, {}, {}, {}, {}, &looks};
  for (const MeshFormat format : {MeshFormat::kGlb, MeshFormat::kPly}) {
    SCOPED_TRACE(format_row(format).ending);
    const std::string bytes = encoded(view, format);
    const auto back = format == MeshFormat::kPly ? read_ply(bytes, "a") : read_gltf(bytes, "a");
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_FALSE(back->looks.normals.any());
    EXPECT_EQ(back->looks.tangents.any(), format == MeshFormat::kGlb);
    EXPECT_EQ(back->positions.size(), 4u);
    ASSERT_EQ(back->looks.uv_sets.size(), 1u);
  }
}

// Returns the first line with this keyword; empty if there is none.
std::string text_with(const std::string& keyword, const std::vector<MtlLine>& lines) {
  for (const MtlLine& line : lines) {
    if (line.text.starts_with(keyword + ' ')) return line.text;
  }
  return "";
}

TEST(UvTransform, is_that_of_the_base_colour_map_and_survives_conversion) {
  SurfaceMaterial turned;
  turned.gltf = R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions": {
      "KHR_texture_transform": {"offset": [0.25, 0.5], "rotation": 1.5707963267948966, "scale": [2, 3]}}}}})";
  const glm::vec2 uv(0.1f, 0.7f);
  const glm::vec2 by_gltf = read_uv_transform(turned) * glm::vec3(uv, 1);
  EXPECT_NEAR(by_gltf.x, 0.25 + 3 * 0.7, 1e-6);
  EXPECT_NEAR(by_gltf.y, 0.5 - 2 * 0.1, 1e-6);

  SurfaceLibrary library;
  library.images.push_back({"paint.png", "", "image/png", kPng});
  SurfaceMaterial& tiled = library.materials.emplace_back();
  tiled.mtl = {{"map_Kd -s 2 3 1 -o 0.25 -0.5 -clamp on ", 0u}};
  tiled.uv_transform = read_uv_transform(tiled);
  const glm::vec2 by_mtl = tiled.uv_transform * glm::vec3(uv.x, 1 - uv.y, 1);  // v down
  EXPECT_NEAR(by_mtl.x, 2 * 0.1 + 0.25, 1e-6);
  EXPECT_NEAR(1 - by_mtl.y, 3 * 0.7 - 0.5, 1e-6);

  const GltfSurfaces converted =
      gltf_surfaces(std::array{GltfMaterial{&library, 0, "paint"}}, MissingImages::kKeep);
  SurfaceLibrary back{{}, library.images, {R"({"source": 0})"}, {}, {}};
  SurfaceMaterial& material = back.materials.emplace_back();
  material.gltf = converted.materials[0].dump();
  material.uv_transform = read_uv_transform(material);
  EXPECT_EQ(material.uv_transform, tiled.uv_transform);
  EXPECT_EQ(converted.used_extensions, std::vector<std::string>{"KHR_texture_transform"});
  SurfaceMaterial again;
  again.mtl = mtl_lines(back, material);
  EXPECT_EQ(text_with("map_Kd", again.mtl), "map_Kd -s 2 3 1 -o 0.25 -0.5 0 ");
  EXPECT_EQ(read_uv_transform(again), tiled.uv_transform);
}

TEST(UvTransform, is_read_from_mtl_in_any_case_and_with_tabs) {
  SurfaceMaterial plain, other;
  plain.mtl = {{"map_Kd -s 2 3 1 -o 0.25 -0.5 0 ", 0u}};
  other.mtl = {{"map_kd\t-S\t2 3 1\t-o\t0.25\t-0.5\t0\t", 0u}};
  EXPECT_EQ(read_uv_transform(other), read_uv_transform(plain));
  other.mtl = {{"map_Kd_gloss -s 2 3 1 ", 0u}};
  EXPECT_EQ(read_uv_transform(other), SurfaceMaterial().uv_transform);
}

// A second round trip through a format changes nothing.
TEST(LooksOfGltf, round_trip_exactly_between_gltf_files) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Soup soup;
    for (int i = 0; i < 20; ++i)
      soup.positions.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    CornerLooks& looks = soup.looks;
    looks.uv_sets.resize(2);
    looks.v_points_down = true;
    for (int i = 0; i < 30; ++i) {
      for (auto& set : looks.uv_sets)
        set.values.emplace_back(glm::dvec2(random.uniform(-9, 9), random.uniform(0, 1)));
      looks.normals.values.emplace_back(
          glm::normalize(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))));
    }
    const auto corners = [&](uint64_t count) {
      return std::array<uint32_t, 3>{static_cast<uint32_t>(random.below(count)),
                                     static_cast<uint32_t>(random.below(count)),
                                     static_cast<uint32_t>(random.below(count))};
    };
    for (int t = 0; t < 40; ++t) {
      soup.triangles.push_back(corners(20));
      for (auto& set : looks.uv_sets) set.corners.push_back(corners(30));
      looks.normals.corners.push_back(corners(30));
    }
    const MeshView view{soup.positions, soup.triangles, {}, {}, {}, {}, {}, &looks};
    const auto back = read_gltf(encoded(view, MeshFormat::kGlb), "a");
    ASSERT_TRUE(back.ok()) << back.error().message;
    ASSERT_EQ(back->looks.uv_sets.size(), 2u);
    for (size_t set = 0; set < 2; ++set) expect_near(back->looks.uv_sets[set], looks.uv_sets[set], 0);
    expect_near(back->looks.normals, looks.normals, 1e-6f);
    const auto obj = read_obj(
        encoded({soup.positions, soup.triangles, {}, {}, {}, {}, {}, &looks}, MeshFormat::kObj), "a.obj");
    ASSERT_TRUE(obj.ok()) << obj.error().message;
    EXPECT_EQ(obj->triangles, soup.triangles);
    auto uvs = obj->looks.uv_sets[0];
    for (glm::vec2& uv : uvs.values) uv.y = 1 - uv.y;
    expect_near(uvs, looks.uv_sets[0], 1e-6f);
    expect_near(obj->looks.normals, looks.normals, 0);
    const auto ply = read_ply(
        encoded({soup.positions, soup.triangles, {}, {}, {}, {}, {}, &looks}, MeshFormat::kPly), "a.ply");
    ASSERT_TRUE(ply.ok()) << ply.error().message;
    uvs = ply->looks.uv_sets[0];
    for (glm::vec2& uv : uvs.values) uv.y = 1 - uv.y;
    expect_near(uvs, looks.uv_sets[0], 1e-6f);
    expect_near(ply->looks.normals, looks.normals, 0);
  }
}

TEST(LooksOfPly, are_read_per_vertex_or_per_corner) {
  const std::string head =
      "ply\nformat ascii 1.0\ncomment TextureFile paint.png\nelement vertex 3\n"
      "property float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
  const auto by_vertex = read_ply(head + "property double texture_u\nproperty double texture_v\n" + face +
                                      "end_header\n0 0 0 0.5 1\n1 0 0 0 1\n1 1 0 0.25 0\n3 0 1 2\n",
                                  "a.ply");
  const auto by_corner = read_ply(head + face +
                                      "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n1 1 0\n"
                                      "3 0 1 2 6 0.5 1 0 1 0.25 0\n",
                                  "a.ply");
  for (const auto* soup : {&by_vertex, &by_corner}) {
    ASSERT_TRUE(soup->ok()) << soup->error().message;
    ASSERT_EQ((*soup)->looks.uv_sets.size(), 1u);
    EXPECT_EQ(values_of((*soup)->looks.uv_sets[0]), (std::vector<glm::vec2>{{0.5f, 1}, {0, 1}, {0.25f, 0}}));
    EXPECT_EQ((*soup)->surfaces, nullptr);  // without a folder
  }
}

TEST(LooksOfPly, are_read_per_corner_after_strips_without_them) {
  const auto soup = read_ply(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nelement face 1\n"
      "property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 2 1 0 6 0.5 1 0 1 0.25 0\n",
      "a.ply");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  ASSERT_EQ(soup->looks.uv_sets.size(), 1u);
  const auto& uvs = soup->looks.uv_sets[0];
  ASSERT_EQ(uvs.corners.size(), 2u);
  EXPECT_EQ(uvs.corners[0], (std::array<uint32_t, 3>{uvs.kNone, uvs.kNone, uvs.kNone}));
  const std::vector<glm::vec2> all = values_of(uvs);
  EXPECT_EQ(std::vector(all.begin() + 3, all.end()), (std::vector<glm::vec2>{{0.5f, 1}, {0, 1}, {0.25f, 0}}));
}

TEST(LooksOfPly, have_a_material_with_the_name_of_the_image) {
  const TemporaryFolder folder;
  const std::string elements =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n";
  const std::string head = "ply\nformat ascii 1.0\n", texture = "comment TextureFile ";
  std::filesystem::create_directories(folder / "maps");
  write_text(folder / "maps/paint.png", kPng);
  const auto painted =
      read_ply(head + texture + "maps/paint.png\n" + elements, "a.ply", nullptr, folder.path());
  ASSERT_TRUE(painted.ok()) << painted.error().message;
  EXPECT_EQ(painted->material_names, std::vector<std::string>{"paint.png"});
  EXPECT_TRUE(painted->materials.empty());
  EXPECT_EQ(painted->surfaces->images[0].bytes, kPng);
  EXPECT_TRUE(painted->warnings.empty());
  const auto second = read_ply(head + texture + "maps/paint.png\n" + texture + "b.png\n" + elements, "a.ply",
                               nullptr, folder.path());
  ASSERT_TRUE(second.ok()) << second.error().message;
  EXPECT_EQ(second->surfaces->images.size(), 1u);
  EXPECT_EQ(second->warnings, std::vector<std::string>{"Only the first of 2 textures was read."});
  const auto nameless = read_ply(head + texture + "maps/\n" + elements, "a.ply", nullptr, folder.path());
  ASSERT_TRUE(nameless.ok()) << nameless.error().message;
  EXPECT_EQ(nameless->material_names, std::vector<std::string>{"texture"});
  const auto plain = read_ply(head + elements, "a.ply", nullptr, folder.path());
  ASSERT_TRUE(plain.ok()) << plain.error().message;
  EXPECT_TRUE(plain->material_names.empty());
}

TEST(GltfSurfaces, keep_extensions_and_renumber_textures) {
  SurfaceLibrary library;
  library.images = {{"unused", "", "image/png", "u"}, {"a", "", "image/png", "a"}, {"gone", "", "", ""}};
  library.samplers = {R"({"wrapS":1})", R"({"wrapS":2})"};
  library.textures = {R"({"source":0})",
                      R"({"source":1,"sampler":1,"extensions":{"EXT_texture_webp":{"source":1}}})",
                      R"({"source":2})"};
  library.required_extensions = {"KHR_materials_odd", "KHR_not_used"};
  library.materials = {
      {{}, R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})"},
      {{},
       R"({"name":"other","normalTexture":{"index":1,"extensions":{"KHR_texture_transform":{"scale":[2,2]}}},)"
       R"("occlusionTexture":{"index":2},"emissiveTexture":{"index":77},)"
       R"("extensions":{"KHR_materials_odd":{"oddTexture":{"index":1},"odd":[1,{"x":3}]}}})"}};
  const std::vector<GltfMaterial> used{{&library, 1, "second"}};
  const GltfSurfaces out = gltf_surfaces(used);
  EXPECT_EQ(
      out.materials.dump(),
      R"([{"name":"second","normalTexture":{"index":0,"extensions":{"KHR_texture_transform":{"scale":[2,2]}}},)"
      R"("extensions":{"KHR_materials_odd":{"oddTexture":{"index":0},"odd":[1,{"x":3}]}}}])");
  EXPECT_EQ(out.textures.dump(),
            R"([{"source":0,"sampler":0,"extensions":{"EXT_texture_webp":{"source":0}}}])");
  EXPECT_EQ(out.samplers.dump(), R"([{"wrapS":2}])");
  EXPECT_EQ(out.sources, std::vector<const SurfaceImage*>{&library.images[1]});
  EXPECT_EQ(out.used_extensions,
            (std::vector<std::string>{"EXT_texture_webp", "KHR_materials_odd", "KHR_texture_transform"}));
  EXPECT_EQ(out.required_extensions, std::vector<std::string>{"KHR_materials_odd"});
}

TEST(GltfSurfaces, leave_out_images_of_mtl_other_than_png_and_jpeg) {
  SurfaceLibrary library;
  library.images = {{"paint.tga", "", "", "tga"}, {"glow.png", "", "image/png", "png"}};
  library.materials.resize(1);
  library.materials[0].mtl = {{"map_Kd ", 0u}, {"map_Ke ", 1u}};
  const std::vector<GltfMaterial> used{{&library, 0, "paint"}};
  const GltfSurfaces out = gltf_surfaces(used);
  EXPECT_EQ(out.sources, std::vector<const SurfaceImage*>{&library.images[1]});
  EXPECT_FALSE(out.materials[0]["pbrMetallicRoughness"].contains("baseColorTexture"));
  EXPECT_EQ(out.materials[0]["emissiveTexture"]["index"], 0);
  EXPECT_EQ(out.materials[0]["pbrMetallicRoughness"]["roughnessFactor"], 1) << "without Ns";
  EXPECT_EQ(lost_in_gltf(library, library.materials[0]), std::vector<std::string>{"map_Kd"});
  EXPECT_EQ(gltf_surfaces(used, MissingImages::kKeep).sources.size(), 2u);
}

TEST(GltfSurfaces, keep_the_transform_of_each_map_and_the_scale_of_normals) {
  SurfaceLibrary library;
  library.images = {{"paint.png", "", "image/png", kPng}};
  SurfaceMaterial& material = library.materials.emplace_back();
  material.mtl = {
      {"map_Kd -s 2 3 1 -o 0.25 -0.5 0 ", 0u}, {"map_Ke ", 0u}, {"norm -bm 0.5 -s 4 8 1 -o 0 0 0 ", 0u}};
  material.uv_transform = read_uv_transform(material);
  const auto converted = gltf_surfaces(std::array{GltfMaterial{&library, 0, "paint"}}).materials[0];
  const auto& normal = converted["normalTexture"];
  EXPECT_EQ(normal["scale"], 0.5);
  EXPECT_EQ(normal["extensions"]["KHR_texture_transform"].dump(),
            R"({"offset":[0.0,-7.0],"scale":[4.0,8.0]})");
  EXPECT_EQ(converted["emissiveTexture"].dump(), R"({"index":0})");

  SurfaceLibrary back{{}, library.images, {R"({"source": 0})"}, {}, {}};
  SurfaceMaterial& again = back.materials.emplace_back();
  again.gltf = converted.dump();
  again.uv_transform = read_uv_transform(again);
  const auto lines = mtl_lines(back, again);
  for (const MtlLine& line : material.mtl)
    EXPECT_EQ(text_with(line.text.substr(0, line.text.find(' ')), lines), line.text);
  EXPECT_EQ(lost_in_mtl(back, again), std::vector<std::string>{});
}

TEST(GltfSurfaces, without_a_description_are_no_metals) {
  SurfaceLibrary library;
  library.materials.resize(1);
  const std::array<GltfMaterial, 3> used{
      {{&library, 0, "bare"}, {&library, 1, "cut"}, {nullptr, 0, "other"}}};
  const GltfSurfaces out = gltf_surfaces(used);
  for (const auto& material : out.materials) {
    ASSERT_TRUE(material.contains("pbrMetallicRoughness")) << material;
    EXPECT_EQ(material["pbrMetallicRoughness"].dump(), R"({"metallicFactor":0})");
    SurfaceMaterial back;
    back.gltf = material.dump();
    EXPECT_EQ(text_with("Pm", mtl_lines({}, back)), "Pm 0");
    EXPECT_EQ(lost_in_3mf(back), std::vector<std::string>{});
    back.gltf = R"({"pbrMetallicRoughness": {"metallicFactor": 0.5}})";
    EXPECT_EQ(lost_in_3mf(back), std::vector<std::string>{"metallicFactor"});
  }
}

TEST(LostInGltf, has_options_and_second_maps_of_a_kind) {
  SurfaceLibrary library;
  library.images = {{"paint.png", "", "image/png", kPng}};
  SurfaceMaterial& material = library.materials.emplace_back();
  material.mtl = {{"Kd 1 0 0", {}},
                  {"map_Kd -S 2 -2 -o -0.5 -Clamp on -bm 2 ", 0u},
                  {"map_Bump ", 0u},
                  {"norm -bm -1 -imfchan l ", 0u},
                  {"bump -bm -1 -imfchan l ", 0u}};
  EXPECT_EQ(lost_in_gltf(library, material),
            (std::vector<std::string>{"map_Bump", "map_Kd -bm", "map_Kd -clamp", "norm -imfchan"}));
}

TEST(LostInGltf, has_statements_without_a_counterpart) {
  SurfaceLibrary library;
  SurfaceMaterial& material = library.materials.emplace_back();
  for (const char* line : {"# painted", "Kd 1 0 0", "Ke 0 0 0", "Ks 0.5 0.5 0.4", "Ni 1.3", "Tf 1 1 1",
                           "d 0.5", "Tr 0.5", "Ns 10", "Pr 0.5", "Pm 0", "illum 2", "KS 1"})
    material.mtl.push_back({line});
  EXPECT_EQ(lost_in_gltf(library, material), (std::vector<std::string>{"KS", "Ks", "Ni", "Tf"}));
  EXPECT_EQ(lost_in_3mf(material),
            (std::vector<std::string>{"KS", "Ke", "Ks", "Ni", "Ns", "Pm", "Pr", "Tf"}));
}

TEST(LostInGltf, omits_default_values_of_the_exporter) {
  SurfaceLibrary library;
  SurfaceMaterial& material = library.materials.emplace_back();
  for (const char* line :
       {"Ns 250.000000", "Ka 1.000000 1.000000 1.000000", "Kd 0.8 0.1 0.1", "Ks 0.500000 0.500000 0.500000",
        "Ke 0.000000 0.000000 0.000000", "Ni 1.450000", "d 1.000000", "illum 2", "Ni 1.5"})
    material.mtl.push_back({line});
  EXPECT_EQ(lost_in_gltf(library, material), std::vector<std::string>{});
  EXPECT_EQ(lost_in_3mf(material), (std::vector<std::string>{"Ke", "Ns"}));
  for (const char* line : {"Ka 0 0 0", "ks 0.5", "Ni"}) material.mtl.push_back({line});
  EXPECT_EQ(lost_in_gltf(library, material), (std::vector<std::string>{"Ka", "Ni", "ks"}));
  material.mtl = {{"Ke 0 2 0", {}}};
  EXPECT_EQ(lost_in_gltf(library, material), std::vector<std::string>{"Ke above 1"});
}

TEST(LostIn3mf, has_factors_without_a_counterpart) {
  SurfaceMaterial material;
  material.gltf = R"({"name":"red","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1],"metallicFactor":0,)"
                  R"("roughnessFactor":0.5},"emissiveFactor":[1,1,1]})";
  EXPECT_EQ(lost_in_3mf(material), (std::vector<std::string>{"emissiveFactor", "roughnessFactor"}));
  material.gltf = R"({"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}})";  // metallic by default
  EXPECT_EQ(lost_in_3mf(material), std::vector<std::string>{"metallicFactor"});
}

TEST(MtlLines, report_textures_of_other_uvs_and_rotated_ones) {
  SurfaceLibrary library;
  library.images = {{"paint.png", "", "image/png", kPng}};
  library.textures = {R"({"source":0})"};
  SurfaceMaterial& material = library.materials.emplace_back();
  material.gltf = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1}},)"
                  R"("emissiveTexture":{"index":0,"texCoord":0},"emissiveFactor":[1,1,1],)"
                  R"("occlusionTexture":{"index":0,"texCoord":1},)"
                  R"("normalTexture":{"index":0,"extensions":{"KHR_texture_transform":{"rotation":1}}}})";
  const auto lines = mtl_lines(library, material);
  EXPECT_EQ(text_with("map_Kd", lines), "");
  EXPECT_EQ(text_with("map_Ke", lines), "map_Ke ");
  EXPECT_EQ(
      lost_in_mtl(library, material),
      (std::vector<std::string>{"KHR_texture_transform", "baseColorTexture texCoord", "occlusionTexture"}));
}

// The default of the factor in glTF is black, that of MTL is white.
TEST(MtlLines, have_no_emission_map_without_a_factor) {
  SurfaceLibrary library;
  library.images = {{"glow.png", "", "image/png", kPng}};
  library.textures = {R"({"source":0})"};
  SurfaceMaterial& material = library.materials.emplace_back();
  for (const std::string factor : {"", R"(,"emissiveFactor":[0,0,0])", R"(,"emissiveFactor":[0,0.5,0])"}) {
    material.gltf = R"({"emissiveTexture":{"index":0})" + factor + "}";
    const bool glows = factor.find("0.5") != std::string::npos;
    EXPECT_EQ(text_with("map_Ke", mtl_lines(library, material)), glows ? "map_Ke " : "") << factor;
    EXPECT_EQ(lost_in_mtl(library, material).size(), glows ? 0u : 1u) << factor;
  }
}

TEST(MtlLines, report_textures_that_do_not_repeat) {
  SurfaceLibrary library;
  library.images = {{"paint.png", "", "image/png", kPng}};
  library.samplers = {R"({"magFilter":9729,"wrapS":10497})", R"({"wrapS":33071,"wrapT":10497})"};
  library.textures = {R"({"source":0})", R"({"source":0,"sampler":0})", R"({"source":0,"sampler":1})"};
  SurfaceMaterial& material = library.materials.emplace_back();
  material.gltf = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":1}},"normalTexture":{"index":0}})";
  EXPECT_EQ(lost_in_mtl(library, material), std::vector<std::string>{});
  material.gltf = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":2}},"normalTexture":{"index":9}})";
  EXPECT_EQ(lost_in_mtl(library, material), std::vector<std::string>{"baseColorTexture wrapS"});
}

// KHR_texture_transform may name another set of UVs than the texture.
TEST(MtlLines, have_no_textures_whose_transform_uses_other_uvs) {
  SurfaceLibrary library;
  library.images = {{"paint.png", "", "image/png", kPng}};
  library.textures = {R"({"source":0})"};
  SurfaceMaterial& material = library.materials.emplace_back();
  material.gltf = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":)"
                  R"({"KHR_texture_transform":{"texCoord":1}}}},"normalTexture":{"index":0,"texCoord":1,)"
                  R"("extensions":{"KHR_texture_transform":{"texCoord":0}}},)"
                  R"("emissiveFactor":[1,1,1],"emissiveTexture":{"index":0,"texCoord":1}})";
  const auto lines = mtl_lines(library, material);
  EXPECT_EQ(text_with("map_Kd", lines), "");
  EXPECT_EQ(text_with("Ke", lines), "") << "the whole surface would glow";
  EXPECT_EQ(text_with("norm", lines), "norm ");
  EXPECT_EQ(lost_in_mtl(library, material),
            (std::vector<std::string>{"baseColorTexture texCoord", "emissiveTexture texCoord"}));
  const auto looks = surface_looks(library);
  ASSERT_TRUE(looks.size() == 1 && looks[0]);
  EXPECT_FALSE(looks[0]->maps[static_cast<size_t>(SurfaceMap::kBase)]);
  EXPECT_TRUE(looks[0]->maps[static_cast<size_t>(SurfaceMap::kNormal)]);
  EXPECT_EQ(looks[0]->emission, Vec3(0));
}

TEST(MtlLines, have_the_opacity_of_the_alpha_mode) {
  SurfaceLibrary library;
  library.images = {{"paint.png", "", "image/png", kPng}};
  library.textures = {R"({"source":0})"};
  const std::string pbr =
      R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25],"baseColorTexture":{"index":0}})";
  for (const std::string mode : {"", "OPAQUE", "MASK", "BLEND"}) {
    SurfaceMaterial material;
    material.gltf = "{" + pbr + (mode.empty() ? "" : R"(,"alphaMode":")" + mode + "\"") + "}";
    const auto lines = mtl_lines(library, material);
    const bool translucent = mode == "MASK" || mode == "BLEND";
    EXPECT_EQ(text_with("d", lines), translucent ? "d 0.25" : "d 1") << mode;
    EXPECT_EQ(text_with("map_d", lines), translucent ? "map_d " : "") << mode;
  }
}

TEST(SurfaceLooks, have_the_image_of_each_map) {
  SurfaceLibrary library;
  for (const char* name : {"a", "b", "c", "d", "e"}) library.images.push_back({name, "", "image/png", kPng});
  for (int i = 4; i >= 0; --i) library.textures.push_back(R"({"source":)" + std::to_string(i) + "}");
  library.materials = {
      {{},
       R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1}},)"
       R"("normalTexture":{"index":2},"occlusionTexture":{"index":3},"emissiveTexture":{"index":4}})"}};
  const auto looks = surface_looks(library);
  ASSERT_TRUE(looks.size() == 1 && looks[0]);
  const auto image = [&](SurfaceMap map) { return looks[0]->maps[static_cast<size_t>(map)]; };
  EXPECT_EQ(image(SurfaceMap::kBase), 4u);
  EXPECT_EQ(image(SurfaceMap::kMetallicRoughness), 3u);
  EXPECT_EQ(image(SurfaceMap::kNormal), 2u);
  EXPECT_EQ(image(SurfaceMap::kOcclusion), 1u);
  EXPECT_EQ(image(SurfaceMap::kEmission), 0u);
}

TEST(SurfaceLooks, convert_specular_glossiness_to_metallic_roughness) {
  SurfaceLibrary library;
  library.images = {{"paint.png", "", "image/png", kPng}};
  library.textures = {R"({"source":0})"};
  const std::string old = R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{"glossinessFactor":0.25,)"
                          R"("diffuseFactor":[1,0,0,1],"diffuseTexture":{"index":0,"extensions":)"
                          R"({"KHR_texture_transform":{"scale":[2,3]}}}}})";
  library.materials = {{{}, "{" + old + "}"}, {{}, R"({"pbrMetallicRoughness":{},)" + old + "}"}};
  const auto looks = surface_looks(library);
  ASSERT_TRUE(looks.size() == 2 && looks[0] && looks[1]);
  EXPECT_EQ(looks[0]->base, glm::dvec4(1, 0, 0, 1));
  EXPECT_EQ(looks[0]->metallic, 0);
  EXPECT_EQ(looks[0]->roughness, 0.75);
  EXPECT_EQ(looks[0]->maps[static_cast<size_t>(SurfaceMap::kBase)], 0u);
  EXPECT_EQ(read_uv_transform(library.materials[0])[1].y, 3);
  EXPECT_EQ(looks[1]->base, glm::dvec4(1));
  EXPECT_EQ(looks[1]->metallic, 1);
  const auto lines = mtl_lines(library, library.materials[0]);
  EXPECT_EQ(text_with("Kd", lines), "Kd 1 0 0");
  EXPECT_EQ(text_with("Pm", lines), "Pm 0");
  EXPECT_EQ(text_with("Pr", lines), "Pr 0.75");
  EXPECT_EQ(text_with("map_Kd", lines), "map_Kd -s 2 3 1 -o 0 -2 0 ");
}

TEST(LooksOfGltf, survive_damaged_attributes_and_deep_materials) {
  const Soup plain = *read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "a.obj");
  const MeshView view{plain.positions, plain.triangles, {}, {}};
  auto file = nlohmann::json::parse(encoded(view, MeshFormat::kGltf));
  file["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 1;  // the indices
  std::string deep = "1";
  for (int i = 0; i < 5000; ++i) deep = "[" + deep + "]";
  std::string text = file.dump();
  text.insert(1, R"("materials":[{"extras":)" + deep + R"(}],"images":[7,{"uri":"../x.png"}],"textures":7,)");
  text.replace(text.find(R"("indices")"), 9, R"("material":0,"indices")");
  const auto soup = read_gltf(text, "a.gltf");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  EXPECT_FALSE(soup->looks.any());
  ASSERT_EQ(soup->warnings.size(), 4u);
  EXPECT_EQ(soup->warnings[0], "Unreadable normals or UVs were ignored.");
}

}  // namespace
}  // namespace kerf::test
