#include "ui/render/bodies/surface_textures.h"

#include <gtest/gtest.h>

#include "core/document/text/json.h"
#include "core/mesh/files/readers.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/render/stage.h"

namespace kerf::test {
namespace {

constexpr int kSize = 200;
constexpr double kHalf = 1;  // m, of the square

// An image of four quadrants: red, green; blue, white.
std::string four_colours(const TemporaryFolder& folder) {
  constexpr int kSide = 64;
  Pixels pixels{kSide, kSide, {}};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool right = x >= kSide / 2, below = y >= kSide / 2;
      const uint8_t white = right && below ? 255 : 0;
      pixels.rgb.insert(pixels.rgb.end(), {static_cast<uint8_t>(!right && !below ? 255 : white),
                                           static_cast<uint8_t>(right && !below ? 255 : white),
                                           static_cast<uint8_t>(!right && below ? 255 : white)});
    }
  }
  const auto file = folder.path() / "image.png";
  EXPECT_TRUE(write_png(pixels, file).ok());
  return *read_text_file(file);
}

// A square in y = 0 that an image covers, the top of the image at z = -1; optionally without UVs.
Soup square(bool has_uvs = true) {
  const std::string positions = "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\n";
  auto soup =
      read_obj(positions + (has_uvs ? "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl skin\nf 1/1 2/2 3/3 4/4\n"
                                    : "usemtl skin\nf 1 2 3 4\n"),
               "square.obj");
  EXPECT_TRUE(soup.ok());
  return std::move(*soup);
}

World painted_square(const std::string& image, const std::string& material, bool has_uvs = true) {
  Soup soup = square(has_uvs);
  auto library = std::make_shared<SurfaceLibrary>();
  library->materials.resize(2);
  library->materials[0].gltf = library->materials[1].gltf = material;
  library->images.push_back({"image.png", "", "image/png", image});
  library->textures.emplace_back(R"({"source": 0})");
  soup.surfaces = library;
  World world;
  world.add(make_body("square", build(soup)));
  return world;
}

// The square with the last of some materials, each of which has an image of its own; all but the last image
// are missing.
World square_with_the_last_of(uint16_t materials, const std::string& image) {
  Soup soup = square();
  soup.materials.assign(soup.triangles.size(), static_cast<uint16_t>(materials - 1));
  soup.material_names.clear();
  auto library = std::make_shared<SurfaceLibrary>();
  library->materials.resize(materials);
  for (uint16_t m = 0; m < materials; ++m) {
    const std::string number = std::to_string(m);
    soup.material_names.push_back(number);
    library->materials[m].gltf =
        R"({"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": )" + number + "}}}";
    library->textures.emplace_back(R"({"source": )" + number + "}");
    library->images.push_back({number + ".png", "", "image/png", m + 1 == materials ? image : ""});
  }
  soup.surfaces = library;
  World world;
  world.add(make_body("square", build(soup)));
  return world;
}

CameraView from_above() { return look_at({0, 4, 0.01}, {0, 0, 0}, 1); }

ViewOptions plain_options() {
  ViewOptions options;
  options.show.shadows = Shadows::kNone;
  return options;
}

std::array<int, 3> pixel(const Pixels& pixels, double x, double z) {
  // The square fills a part of the view that follows from its bounds in the picture.
  const auto column = static_cast<int>((0.5 + 0.15 * x / kHalf) * pixels.width);
  const auto row = static_cast<int>((0.5 + 0.15 * z / kHalf) * pixels.height);
  const auto at = 3 * static_cast<size_t>(row * pixels.width + column);
  return {pixels.rgb[at], pixels.rgb[at + 1], pixels.rgb[at + 2]};
}

// The channels of a pixel that are clearly brighter than its darkest one, as bits; 7 for grey.
int strong_channels(const Pixels& pixels, double x, double z) {
  const auto rgb = pixel(pixels, x, z);
  const int darkest = std::min({rgb[0], rgb[1], rgb[2]});
  int bits = 0;
  for (int k = 0; k < 3; ++k) bits |= rgb[static_cast<size_t>(k)] > darkest + 40 ? 1 << k : 0;
  return bits == 0 ? 7 : bits;
}

void expect_four_colours(const Pixels& pixels) {
  EXPECT_EQ(strong_channels(pixels, -0.7, -0.7), 1);
  EXPECT_EQ(strong_channels(pixels, 0.7, -0.7), 2);
  EXPECT_EQ(strong_channels(pixels, -0.7, 0.7), 4);
  EXPECT_EQ(strong_channels(pixels, 0.7, 0.7), 7);
}

constexpr const char* kTextured =
    R"({"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 0}}})";

TEST(SurfaceTextures, map_the_image_by_uvs_even_after_a_cut) {
  const TemporaryFolder folder;
  Stage stage(painted_square(four_colours(folder), kTextured));
  expect_four_colours(stage.draw(from_above(), plain_options(), kSize, kSize));
  stage.cut({{-2, 1, 0.1}, {0, -1, 0}}, {{2, 1, 0.2}, {0, -1, 0}}, 0.05);
  EXPECT_GT(stage.world().live_faces(), 20u);
  expect_four_colours(stage.draw(from_above(), plain_options(), kSize, kSize));
}

TEST(SurfaceTextures, show_the_last_of_256_images) {
  const TemporaryFolder folder;
  Stage stage(square_with_the_last_of(256, four_colours(folder)));
  expect_four_colours(stage.draw(from_above(), plain_options(), kSize, kSize));
}

TEST(SurfaceTextures, are_omitted_if_faces_are_coloured_by_piece) {
  const TemporaryFolder folder;
  Stage stage(painted_square(four_colours(folder), kTextured));
  ViewOptions options = plain_options();
  options.show.pieces = true;
  const Pixels pixels = stage.draw(from_above(), options, kSize, kSize);
  EXPECT_EQ(strong_channels(pixels, -0.7, -0.7), strong_channels(pixels, 0.7, -0.7));
}

TEST(SurfaceTextures, show_a_checkerboard_for_a_damaged_image) {
  Stage stage(painted_square("no image", kTextured));
  const Pixels pixels = stage.draw(from_above(), plain_options(), kSize, kSize);
  int darkest = 255, brightest = 0;
  for (double x = -0.9; x < 0.9; x += 0.02) {
    const auto rgb = pixel(pixels, x, 0.3);
    darkest = std::min(darkest, rgb[1]);
    brightest = std::max(brightest, rgb[1]);
  }
  EXPECT_GT(brightest, darkest + 20);
}

TEST(SurfaceTextures, alpha_mask_discards_transparent_parts) {
  const auto drawn = [](const std::string& material) {
    Stage stage(painted_square("", material));
    return pixel(stage.draw(from_above(), plain_options(), kSize, kSize), 0.5, 0.5);
  };
  const auto opaque = drawn(R"({"pbrMetallicRoughness": {"metallicFactor": 0}})");
  const auto masked =
      drawn(R"({"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.2]}})");
  EXPECT_GT(opaque[1], 120);
  EXPECT_LT(masked[1], 80);
}

TEST(SurfaceTextures, materials_of_faces_without_uvs_emit_light) {
  Stage stage(painted_square("", R"({"emissiveFactor": [1, 0, 0], "pbrMetallicRoughness":
                                     {"metallicFactor": 0, "baseColorFactor": [0, 0, 0, 1]}})",
                             false));
  EXPECT_EQ(strong_channels(stage.draw(from_above(), plain_options(), kSize, kSize), 0.5, 0.5), 1);
}

TEST(DecodeTexture, rejects_anything_but_an_image) {
  for (const std::string bytes : {"", "P6 1 1 255\nabc", "\x89PNG\r\n\x1a\n", "BM"})
    EXPECT_FALSE(decode_texture(bytes).has_value()) << bytes;
}

TEST(SurfaceLooks, read_both_kinds_of_material_description) {
  SurfaceLibrary library;
  library.materials.resize(3);
  library.materials[0].mtl = {{"Kd 1 0 0"}, {"d 0.5"}, {"map_Kd ", 0u}};
  library.materials[1].gltf = R"({"alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true,
      "emissiveFactor": [0, 2, 0], "normalTexture": {"index": 0, "scale": 0.5},
      "occlusionTexture": {"index": 7}, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}})";
  library.images.resize(1);  // missing
  library.textures.emplace_back(R"({"source": 0})");
  const auto looks = surface_looks(library);
  ASSERT_EQ(looks.size(), 3u);
  ASSERT_TRUE(looks[0] && looks[1] && !looks[2]);
  EXPECT_EQ(looks[0]->base, glm::dvec4(1, 0, 0, 0.5));
  EXPECT_EQ(looks[0]->alpha, SurfaceLook::Alpha::kBlend);
  EXPECT_EQ(looks[0]->maps[static_cast<size_t>(SurfaceMap::kBase)], 0u);
  EXPECT_EQ(looks[1]->cutoff, 0.25);
  EXPECT_TRUE(looks[1]->double_sided);
  EXPECT_EQ(looks[1]->emission, Vec3(0, 2, 0));
  EXPECT_EQ(looks[1]->normal_scale, 0.5);
  EXPECT_EQ(looks[1]->maps[static_cast<size_t>(SurfaceMap::kNormal)], 0u);
  EXPECT_FALSE(looks[1]->maps[static_cast<size_t>(SurfaceMap::kOcclusion)]);
  EXPECT_FALSE(looks[1]->maps[static_cast<size_t>(SurfaceMap::kBase)]);
}

}  // namespace
}  // namespace kerf::test
