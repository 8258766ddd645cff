#include "core/mesh/files/soup_file.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "core/base/platform.h"
#include "core/base/random.h"
#include "core/mesh/looks.h"
#include "core/mesh/mesh_file.h"
#include "tests/core/mesh/files/sample_files.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

// A soup that uses every member, with values that no text or single precision would keep.
Soup full_soup() {
  Soup soup = moved(grid(2, 1 / 3.0), {0.1, 1e-17, 1e9}, 1);
  const auto triangles = static_cast<uint32_t>(soup.triangles.size());
  soup.colours.assign(soup.positions.size(), VertexColour{{1, 2, 3, 65535}});
  soup.material_names = {"red paint", "", "t\xc3\xbcr"};
  for (uint32_t t = 0; t < triangles; ++t) soup.materials.push_back(static_cast<uint16_t>(t % 3));
  soup.parts = {{"left fender", 0, 3}, {"left fender", 2, triangles}};
  constexpr uint32_t kNone = LookChannel<glm::vec2>::kNone;
  CornerLooks& looks = soup.looks;
  looks.uv_sets.resize(2);
  looks.uv_sets[0] = {{{0.1f, 0.2f}, {1e-30f, -3}}, {triangles, {0, 1, 0}}};
  looks.uv_sets[0].corners[1] = {kNone, kNone, kNone};
  looks.uv_sets[1] = {{{7, 8}}, {triangles, {0, 0, 0}}};
  looks.normals = {{{0, 1, 0}}, {triangles, {0, 0, 0}}};
  looks.tangents = {{{1, 0, 0, -1}}, {triangles, {0, 0, 0}}};
  looks.attributes = {{"quality", 3, {{{1, 2, 3, 0}}, {triangles, {0, 0, 0}}}}};
  looks.v_points_down = true;
  auto surfaces = std::make_shared<SurfaceLibrary>();
  surfaces->materials.resize(3);
  surfaces->materials[0].mtl = {{"Kd 0.8 0.1 0.1", {}}, {"map_Kd ", 1}};
  surfaces->materials[1].gltf = R"({"extras":{"a":[1]},"normalTexture":{"index":0}})";
  surfaces->materials[1].uv_transform[2] = {0.5f, 0.25f};
  surfaces->images = {{"a.png", "x/a.png", "image/png", std::string("\x89\0PNG", 5)},
                      {"b.png", "b.png", "", ""}};
  surfaces->textures = {R"({"source":0,"sampler":0})"};
  surfaces->samplers = {R"({"wrapS":33071})"};
  surfaces->required_extensions = {"KHR_texture_transform"};
  soup.surfaces = surfaces;
  return soup;
}

uint64_t looks_hash_of(const Soup& soup) {
  std::vector<std::string> warnings;
  return Looks::make(soup, {}, std::vector<bool>(soup.triangles.size(), false), warnings)->hash();
}

TEST(SoupFile, keeps_everything_to_the_bit) {
  const Soup soup = full_soup();
  const std::string bytes = encode_soup(soup);
  const auto read = read_soup(bytes, "a.kmesh");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(encode_soup(*read), bytes);
  EXPECT_EQ(read->positions, soup.positions);
  EXPECT_EQ(read->triangles, soup.triangles);
  EXPECT_EQ(read->colours, soup.colours);
  EXPECT_EQ(read->materials, soup.materials);
  EXPECT_EQ(read->material_names, soup.material_names);
  EXPECT_EQ(read->parts[1].last, soup.parts[1].last);
  EXPECT_EQ(read->looks.attributes[0].parts, 3);
  EXPECT_TRUE(read->looks.v_points_down);
  EXPECT_EQ(looks_hash_of(*read), looks_hash_of(soup));
  EXPECT_EQ(read->surfaces->materials[1].uv_transform, soup.surfaces->materials[1].uv_transform);
  EXPECT_EQ(read->surfaces->images[0].reference, "x/a.png");
  EXPECT_EQ(read_soup(encode_soup(grid(2, 1)), "a.kmesh")->surfaces, nullptr);
}

TEST(SoupFile, is_read_like_other_mesh_files) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder / "a.kmesh", encode_soup(full_soup())));
  const auto soup = read_mesh(folder / "a.kmesh");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  EXPECT_EQ(encode_soup(*soup), encode_soup(full_soup()));
}

TEST(SoupFile, damaged_bytes_fail_in_one_line_or_are_sound) {
  const std::string bytes = encode_soup(full_soup());
  for (size_t size = 0; size < bytes.size(); ++size) {
    const std::string part = bytes.substr(0, size);
    const auto soup = read_soup(part, "a.kmesh");
    ASSERT_FALSE(soup.ok()) << size;
    EXPECT_TRUE(is_one_line_about(soup.error(), "a.kmesh: ")) << soup.error().message;
  }
  EXPECT_FALSE(read_soup(bytes + "x", "a.kmesh").ok());
  Random random(3);
  const size_t first = 20 + sizeof(Vec3) * full_soup().positions.size();  // finite positions precede the rest
  for (int i = 0; i < 20'000; ++i) {
    std::string changed = bytes;
    for (uint64_t edits = 1 + random.below(3); edits > 0; --edits)
      changed[first + random.below(changed.size() - first)] = static_cast<char>(random.below(256));
    const auto soup = read_soup(changed, "a.kmesh");
    if (!soup) continue;
    std::vector<std::string> warnings;  // visits all indices
    Looks::make(*soup, {}, std::vector<bool>(soup->triangles.size(), false), warnings);
    MeshView view{soup->positions, soup->triangles, soup->materials, soup->material_names};
    view.looks = &soup->looks;
    view.surfaces = soup->surfaces.get();
    EXPECT_FALSE(encoded(view, MeshFormat::kGlb).empty());
  }
}

TEST(SoupFile, needs_values_for_every_triangle) {
  const auto is_read = [](const Soup& soup) { return read_soup(encode_soup(soup), "a.kmesh").ok(); };
  Soup soup = full_soup();
  soup.looks.normals = {};
  soup.looks.tangents = {};
  soup.materials.clear();
  EXPECT_TRUE(is_read(soup));
  soup.looks.uv_sets[0].corners.clear();
  EXPECT_FALSE(is_read(soup));
  soup = full_soup();
  soup.looks.attributes[0].channel.corners.clear();
  EXPECT_FALSE(is_read(soup));
  soup = full_soup();
  soup.looks.normals.corners.pop_back();
  EXPECT_FALSE(is_read(soup));
  soup = grid(2, 1);
  soup.materials.assign(soup.triangles.size(), 0);
  EXPECT_FALSE(is_read(soup)) << "without names of materials";
}

TEST(SoupFile, of_a_later_format_is_refused) {
  std::string bytes = encode_soup(full_soup());
  EXPECT_EQ(bytes[8], 1) << "a new number makes files of this format unreadable for earlier versions";
  bytes[8] = 9;
  const auto soup = read_soup(bytes, "a.kmesh");
  ASSERT_FALSE(soup.ok());
  EXPECT_EQ(soup.error().message,
            "a.kmesh: this Kerf mesh was saved by a later version of Kerf; update Kerf.");
}

}  // namespace
}  // namespace kerf::test
