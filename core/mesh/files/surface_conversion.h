#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json.h"
#include "core/mesh/files/surfaces.h"

namespace kerf {

// Returns pbrMetallicRoughness of a material in glTF. Without it, diffuse colour, diffuse texture and
// glossiness of KHR_materials_pbrSpecularGlossiness are converted to it; otherwise it is empty.
nlohmann::ordered_json metallic_roughness(const nlohmann::ordered_json& material);

// Returns the lines of a material in MTL: as in the file, or converted from glTF: Kd, Ke, d, Pr, Pm, Ns and
// the maps of the base colour, the opacity, the emission and the normals that use the first UVs. Each map has
// the scale and offset of its texture as -s and -o, unless that is rotated, and the normal map its scale as
// -bm. Colours are converted from linear light to sRGB. A material whose alphaMode is OPAQUE has the opacity
// 1 and no map of it, and one whose emission has a map with other UVs has no Ke.
std::vector<MtlLine> mtl_lines(const SurfaceLibrary& library, const SurfaceMaterial& material);

// A material to write. The library, null for none, must outlive all that is made from it.
struct GltfMaterial {
  const SurfaceLibrary* library = nullptr;
  uint16_t number = 0;  // in the library
  std::string_view name{};

  auto operator<=>(const GltfMaterial&) const = default;
};

// The materials of a glTF file, with their textures, samplers and images.
struct GltfSurfaces {
  nlohmann::ordered_json materials, textures, samplers, images;  // arrays; images have no data yet
  std::vector<const SurfaceImage*> sources;                      // by image
  std::vector<std::string> used_extensions, required_extensions;
};

// Returns materials with their names: those of glTF verbatim, with indices of textures renumbered, those of
// MTL converted, and those without a description as not metallic. Files leave out images without bytes, and
// of MTL those other than PNG and JPEG.
enum class MissingImages : uint8_t { kLeaveOut, kKeep };
GltfSurfaces gltf_surfaces(std::span<const GltfMaterial> materials,
                           MissingImages missing = MissingImages::kLeaveOut);

// Return the members, statements and options of maps of a material that these functions do not convert,
// ascending: "occlusionTexture", "Ks", "map_Ns", "map_Kd -clamp". Empty if the material is already in MTL, or
// in glTF. 3MF holds the base colour and the opacity of materials that are not metallic; images are no part
// of its list. The lists omit Ka, Ks and Ni of MTL with the default values of Blender's exporter: Ka 1 1 1,
// Ks 0.5 0.5 0.5, Ni 1.45 or 1.5.
std::vector<std::string> lost_in_mtl(const SurfaceLibrary& library, const SurfaceMaterial& material);
std::vector<std::string> lost_in_gltf(const SurfaceLibrary& library, const SurfaceMaterial& material);
std::vector<std::string> lost_in_3mf(const SurfaceMaterial& material);

}  // namespace kerf
