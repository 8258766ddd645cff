#include "ui/render/bodies/surface_textures.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <future>
#include <glm/vec4.hpp>
#include <utility>

#include "core/base/parallel.h"
#include "ui/gl/image.h"
#include "ui/render/bodies/body_picture.h"

namespace kerf {

namespace {

constexpr size_t kMaterials = 256;  // as in body.frag
constexpr size_t kMaxLayers = 256;  // that every OpenGL 3.3 supports
constexpr float kLayerBase = 512;   // as in body.frag, > kMaxLayers
constexpr int kMaxSide = 2048;      // of a layer
constexpr int kColoursUnit = 4, kNumbersUnit = 5;

// A material in the block "Surfaces" of body.frag.
struct SurfaceEntry {
  glm::vec4 base{1};
  glm::vec4 emission{0};  // w: 1 if the material is described
  glm::vec4 traits{0};    // metallic, roughness, scale of normals, strength of occlusion
  // Layers plus one, or 0, with b = kLayerBase: base + b normal; metallic-roughness + b occlusion; emission +
  // b if double-sided. Opacity below which a fragment is discarded; -1: none, -2: blended.
  glm::vec4 layers{0};
};

constexpr bool has_colours(SurfaceMap map) {
  return map == SurfaceMap::kBase || map == SurfaceMap::kEmission;
}

bool has_any_trait(const std::optional<SurfaceLook>& look) {
  return look && (look->metallic > 0 || look->emission != Vec3(0) ||
                  look->alpha != SurfaceLook::Alpha::kOpaque || look->double_sided);
}

TexturePixels checkerboard() {
  constexpr int kSide = 16, kCell = 4;
  TexturePixels pixels{kSide, kSide, {}};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const auto level = static_cast<uint8_t>((x / kCell + y / kCell) % 2 == 0 ? 205 : 120);
      pixels.rgba.insert(pixels.rgba.end(), {level, level, level, 255});
    }
  }
  return pixels;
}

// Returns the largest side of a layer, a power of two, with which all of them fit into the memory.
int side_of(std::span<const TexturePixels> images, size_t layers) {
  int largest = 1;
  for (const TexturePixels& image : images) largest = std::max({largest, image.width, image.height});
  auto side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::min(largest, kMaxSide))));
  const auto bytes = [&] { return layers * 16 / 3 * static_cast<size_t>(side) * static_cast<size_t>(side); };
  while (side > 1 && bytes() > SurfaceTextures::kMaxBytes) side /= 2;
  return side;
}

}  // namespace

struct SurfaceTextures::Decoding {
  struct Layers {
    int side = 1;
    std::vector<TexturePixels> pixels;  // by layer
  };
  std::future<Layers> result;
};

SurfaceTextures::SurfaceTextures(std::shared_ptr<const SurfaceLibrary> library)
    : library_(std::move(library)),
      looks_(surface_looks(*library_)),
      has_traits_(std::ranges::any_of(looks_, has_any_trait)) {
  fill_block();
  if (layers_.empty()) return;
  decoding_ = std::make_unique<Decoding>();
  decoding_->result = std::async(std::launch::async, [library = library_, layers = layers_] {
    std::vector<TexturePixels> images(library->images.size());
    std::vector<char> is_used(images.size(), 0);
    for (const Layer& layer : layers) is_used[layer.image] = 1;
    for_each_range(images.size(), 1, [&](size_t i, size_t) {
      if (!is_used[i]) return;
      auto decoded = decode_texture(library->images[i].bytes);
      images[i] = decoded ? std::move(*decoded) : checkerboard();
    });
    Decoding::Layers result{side_of(images, layers.size()), {}};
    result.pixels.resize(layers.size());
    for_each_range(layers.size(), 1, [&](size_t i, size_t) {
      result.pixels[i] = resized(images[layers[i].image], result.side, layers[i].colours);
    });
    return result;
  });
}

SurfaceTextures::~SurfaceTextures() = default;

// Returns the layer of a map plus one within the array of its kind; 0 if there is none.
int SurfaceTextures::layer_of(const SurfaceLook& look, SurfaceMap map) {
  const auto image = look.maps[static_cast<size_t>(map)];
  if (!image) return 0;
  int place = 1;
  for (const Layer& layer : layers_) {
    if (layer.colours != has_colours(map)) continue;
    if (layer.image == *image) return place;
    ++place;
  }
  if (layers_.size() >= kMaxLayers) return 0;
  layers_.push_back({*image, has_colours(map)});
  return place;
}

void SurfaceTextures::fill_block() {
  std::array<SurfaceEntry, kMaterials> entries{};
  for (size_t m = 0; m < std::min(kMaterials, looks_.size()); ++m) {
    if (!looks_[m]) continue;
    const SurfaceLook& look = *looks_[m];
    const auto layer = [&](SurfaceMap map) { return static_cast<float>(layer_of(look, map)); };
    SurfaceEntry& entry = entries[m];
    entry.base = glm::vec4(look.base);
    entry.emission = glm::vec4(glm::vec3(look.emission), 1);
    entry.traits =
        glm::vec4(glm::dvec4(look.metallic, look.roughness, look.normal_scale, look.occlusion_strength));
    entry.layers = {layer(SurfaceMap::kBase) + kLayerBase * layer(SurfaceMap::kNormal),
                    layer(SurfaceMap::kMetallicRoughness) + kLayerBase * layer(SurfaceMap::kOcclusion),
                    layer(SurfaceMap::kEmission) + (look.double_sided ? kLayerBase : 0.0f),
                    look.alpha == SurfaceLook::Alpha::kMask    ? static_cast<float>(look.cutoff)
                    : look.alpha == SurfaceLook::Alpha::kBlend ? -2.0f
                                                               : -1.0f};
  }
  gl::fill_buffer(GL_UNIFORM_BUFFER, block_, sizeof(entries), entries.data(), GL_STATIC_DRAW);
}

bool SurfaceTextures::update(bool waits) {
  if (!decoding_) return false;
  if (!waits && decoding_->result.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return false;
  const Decoding::Layers decoded = decoding_->result.get();
  decoding_.reset();
  for (const bool colours : {true, false}) {
    const auto count = std::count_if(layers_.begin(), layers_.end(),
                                     [&](const Layer& layer) { return layer.colours == colours; });
    if (count == 0) continue;
    const gl::Texture& texture = (colours ? colours_ : numbers_).emplace();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.name());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, colours ? GL_SRGB8_ALPHA8 : GL_RGBA8, decoded.side, decoded.side,
                 static_cast<GLsizei>(count), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    GLint place = 0;
    for (size_t i = 0; i < layers_.size(); ++i) {
      if (layers_[i].colours != colours) continue;
      glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, place++, decoded.side, decoded.side, 1, GL_RGBA,
                      GL_UNSIGNED_BYTE, decoded.pixels[i].rgba.data());
    }
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    bytes_ += static_cast<size_t>(count) * 16 / 3 * static_cast<size_t>(decoded.side) *
              static_cast<size_t>(decoded.side);
  }
  glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
  return true;
}

void SurfaceTextures::bind(const gl::Program& program, bool has_uvs) const {
  glBindBufferBase(GL_UNIFORM_BUFFER, kSurfaceBlock, block_.name());
  program.set("has_images", decoding_ || !has_uvs ? 0 : 1);
  program.set_texture("colour_images", kColoursUnit, colours_ ? colours_->name() : 0, GL_TEXTURE_2D_ARRAY);
  program.set_texture("number_images", kNumbersUnit, numbers_ ? numbers_->name() : 0, GL_TEXTURE_2D_ARRAY);
}

}  // namespace kerf
