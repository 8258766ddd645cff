#include "core/mesh/files/surface_look.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <string_view>

#include "core/base/deterministic_math.h"
#include "core/mesh/files/surface_conversion.h"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

const Json& member(const Json& of, const char* key) {
  static const Json kNothing = Json::object();
  return of.is_object() && of.contains(key) ? of[key] : kNothing;
}

double number(const Json& of, const char* key, double otherwise) {
  const Json& value = member(of, key);
  if (!value.is_number()) return otherwise;
  const auto x = value.get<double>();
  return std::isfinite(x) ? x : otherwise;
}

// Reads up to `count` numbers over the defaults in `to`.
template <typename V>
void read_vector(const Json& of, const char* key, V& to) {
  const Json& value = member(of, key);
  if (!value.is_array()) return;
  for (int k = 0; k < V::length() && k < static_cast<int>(value.size()); ++k) {
    const Json& x = value[static_cast<size_t>(k)];
    if (x.is_number() && std::isfinite(x.get<double>())) to[k] = std::max(x.get<double>(), 0.0);
  }
}

std::optional<size_t> index(const Json& of, const char* key, size_t count) {
  const Json& value = member(of, key);
  if (!value.is_number_unsigned() || value.get<uint64_t>() >= count) return std::nullopt;
  return value.get<size_t>();
}

// Reads up to two finite numbers, which may be negative, over the defaults in `to`.
void read_pair(const Json& of, const char* key, glm::dvec2& to) {
  const Json& value = member(of, key);
  for (size_t k = 0; value.is_array() && k < std::min<size_t>(2, value.size()); ++k) {
    if (value[k].is_number() && std::isfinite(value[k].get<double>()))
      to[static_cast<int>(k)] = value[k].get<double>();
  }
}

// Returns a line of MTL in lower case, with blanks in place of tabs.
std::string plain_line(std::string line) {
  for (char& c : line) c = c == '\t' ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return line;
}

// Reads the numbers after an option of a plain line of MTL over the defaults in `to`.
void read_option(const std::string& line, const char* option, glm::dvec2& to) {
  const size_t at = line.find(std::string(" ") + option + " ");
  if (at == std::string::npos) return;
  std::istringstream words(line.substr(at + std::string_view(option).size() + 2));
  words.imbue(std::locale::classic());
  double x = 0;
  for (int k = 0; k < 2 && words >> x && std::isfinite(x); ++k) to[k] = x;
}

glm::mat3x2 uv_transform(const glm::dvec2& scale, const glm::dvec2& offset, double rotation) {
  const SinCos turn = sin_cos(std::fmod(rotation, 2 * kPi));
  return glm::dmat3x2(turn.cos * scale.x, -turn.sin * scale.x, turn.sin * scale.y, turn.cos * scale.y,
                      offset.x, offset.y);
}

class LookReader {
 public:
  LookReader(const SurfaceLibrary& library, const GltfSurfaces& surfaces)
      : library_(library), surfaces_(surfaces) {}

  SurfaceLook read(const Json& material) const {
    SurfaceLook look;
    const Json pbr = metallic_roughness(material);
    read_vector(pbr, "baseColorFactor", look.base);
    // Without its map the factor would light the whole surface.
    if (uses_first_uvs(member(material, "emissiveTexture")))
      read_vector(material, "emissiveFactor", look.emission);
    look.metallic = std::clamp(number(pbr, "metallicFactor", 1), 0.0, 1.0);
    look.roughness = std::clamp(number(pbr, "roughnessFactor", 1), 0.0, 1.0);
    look.cutoff = number(material, "alphaCutoff", 0.5);
    const Json& alpha = member(material, "alphaMode");
    if (alpha == "MASK") look.alpha = SurfaceLook::Alpha::kMask;
    if (alpha == "BLEND") look.alpha = SurfaceLook::Alpha::kBlend;
    look.double_sided = member(material, "doubleSided") == true;
    look.normal_scale = number(member(material, "normalTexture"), "scale", 1);
    look.occlusion_strength = number(member(material, "occlusionTexture"), "strength", 1);
    const auto set = [&](SurfaceMap map, const Json& of, const char* key) {
      look.maps[static_cast<size_t>(map)] = image(member(of, key));
    };
    set(SurfaceMap::kBase, pbr, "baseColorTexture");
    set(SurfaceMap::kNormal, material, "normalTexture");
    set(SurfaceMap::kMetallicRoughness, pbr, "metallicRoughnessTexture");
    set(SurfaceMap::kOcclusion, material, "occlusionTexture");
    set(SurfaceMap::kEmission, material, "emissiveTexture");
    return look;
  }

 private:
  std::optional<uint32_t> image(const Json& use) const {
    if (!uses_first_uvs(use)) return std::nullopt;
    const auto texture = index(use, "index", surfaces_.textures.size());
    if (!texture) return std::nullopt;
    const Json& json = surfaces_.textures[*texture];
    auto source = index(json, "source", surfaces_.sources.size());
    for (const Json& extension : member(json, "extensions")) {
      if (!source) source = index(extension, "source", surfaces_.sources.size());
    }
    if (!source) return std::nullopt;
    return static_cast<uint32_t>(surfaces_.sources[*source] - library_.images.data());
  }

  const SurfaceLibrary& library_;
  const GltfSurfaces& surfaces_;
};

}  // namespace

glm::mat3x2 read_map_transform(const Json& texture) {
  const Json& transform = member(member(texture, "extensions"), "KHR_texture_transform");
  glm::dvec2 scale(1), offset(0);
  read_pair(transform, "scale", scale);
  read_pair(transform, "offset", offset);
  return uv_transform(scale, offset, number(transform, "rotation", 0));
}

glm::mat3x2 read_map_transform(const MtlLine& map) {
  const std::string text = plain_line(map.text);
  glm::dvec2 scale(1), offset(0);
  read_option(text, "-s", scale);
  read_option(text, "-o", offset);
  offset.y = 1 - scale.y - offset.y;  // v = 0 is the bottom of an image in MTL
  return uv_transform(scale, offset, 0);
}

bool uses_first_uvs(const Json& texture) {
  const Json& transform = member(member(texture, "extensions"), "KHR_texture_transform");
  return number(transform, "texCoord", number(texture, "texCoord", 0)) == 0;
}

double read_normal_scale(const MtlLine& map) {
  glm::dvec2 scale(1);
  read_option(plain_line(map.text), "-bm", scale);
  return scale.x;
}

glm::mat3x2 read_uv_transform(const SurfaceMaterial& material) {
  if (!material.gltf.empty()) {
    const Json pbr = metallic_roughness(Json::parse(material.gltf, nullptr, false));
    return read_map_transform(member(pbr, "baseColorTexture"));
  }
  const auto map = std::ranges::find_if(material.mtl, [](const MtlLine& line) {
    return line.image && plain_line(line.text).starts_with("map_kd ");
  });
  return map == material.mtl.end() ? SurfaceMaterial().uv_transform : read_map_transform(*map);
}

std::vector<std::optional<SurfaceLook>> surface_looks(const SurfaceLibrary& library) {
  std::vector<GltfMaterial> materials;
  for (size_t m = 0; m < std::min<size_t>(library.materials.size(), 0xffff); ++m)
    materials.push_back({&library, static_cast<uint16_t>(m)});
  const GltfSurfaces surfaces = gltf_surfaces(materials, MissingImages::kKeep);
  std::vector<std::optional<SurfaceLook>> looks(materials.size());
  for (size_t m = 0; m < materials.size(); ++m) {
    if (library.materials[m].mtl.empty() && library.materials[m].gltf.empty()) continue;
    looks[m] = LookReader(library, surfaces).read(surfaces.materials[m]);
  }
  return looks;
}

}  // namespace kerf
