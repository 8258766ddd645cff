#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/json.h"
#include "core/mesh/files/surfaces.h"

namespace kerf {

// The maps of a surface, as glTF 2.0 defines their channels.
enum class SurfaceMap : uint8_t { kBase, kNormal, kMetallicRoughness, kOcclusion, kEmission };
inline constexpr size_t kSurfaceMaps = 5;

// The appearance of a material of a file, in the terms of glTF 2.0: factors in linear light, multiplied by
// maps.
struct SurfaceLook {
  enum class Alpha : uint8_t { kOpaque, kMask, kBlend };

  glm::dvec4 base{1};  // colour and opacity
  Vec3 emission{0};
  double metallic = 1, roughness = 1;
  double normal_scale = 1, occlusion_strength = 1;
  Alpha alpha = Alpha::kOpaque;
  double cutoff = 0.5;  // opacity below which a mask is transparent
  bool double_sided = false;
  std::array<std::optional<uint32_t>, kSurfaceMaps> maps{};  // by SurfaceMap: index of SurfaceLibrary::images
};

// Returns the looks of the materials of a library; nullopt for those that the file only names. Converts MTL
// like mtl_lines() does. Ignores maps that use another set of UVs than the first, and emission with such a
// map.
std::vector<std::optional<SurfaceLook>> surface_looks(const SurfaceLibrary& library);

// Return the transform of the UVs of a map: KHR_texture_transform of a texture in glTF, or the options -s and
// -o of a map in MTL. Values that are not finite are ignored.
glm::mat3x2 read_map_transform(const nlohmann::ordered_json& texture);
glm::mat3x2 read_map_transform(const MtlLine& map);

// Returns true if a texture in glTF uses the first set of UVs, by its own "texCoord" or that of
// KHR_texture_transform, which takes precedence.
bool uses_first_uvs(const nlohmann::ordered_json& texture);

// Returns the factor of the normals of a map in MTL, its option -bm; 1 without it.
double read_normal_scale(const MtlLine& map);

// Returns the transform of the UVs with which a material is drawn, that of its base colour map: the viewport
// draws all maps of a material with one set of UVs.
glm::mat3x2 read_uv_transform(const SurfaceMaterial& material);

}  // namespace kerf
