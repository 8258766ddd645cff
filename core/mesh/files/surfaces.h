#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

namespace kerf {

// Values at the corners of triangles; equal values may be shared.
template <typename T>
struct LookChannel {
  static constexpr uint32_t kNone = 0xffffffffu;
  using Corners = std::array<uint32_t, 3>;

  std::vector<T> values;
  std::vector<Corners> corners;  // by triangle: indices of values, or kNone; empty if no triangle has values

  bool any() const { return !corners.empty(); }
};

// A custom attribute of a file: numbers without a meaning to Kerf, "_NAME" in glTF and other scalars of the
// vertices in PLY.
struct LookAttribute {
  std::string name;   // without the underscore of glTF
  uint8_t parts = 1;  // numbers in use of each value, 1 .. 4; the others are 0
  LookChannel<glm::vec4> channel;
};
inline constexpr size_t kMaxLookAttributes = 16;  // per file

// The looks of a mesh at the corners of its triangles.
struct CornerLooks {
  std::vector<LookChannel<glm::vec2>> uv_sets;
  LookChannel<glm::vec3> normals;
  LookChannel<glm::vec4> tangents;  // and in w the sign of the bitangent, 1 or -1, as in glTF
  std::vector<LookAttribute> attributes;
  bool v_points_down =
      false;  // v = 0 is the top row of an image, as in glTF; otherwise the bottom, as in OBJ

  bool any() const { return !uv_sets.empty() || normals.any() || tangents.any() || !attributes.empty(); }
};

// An image of a mesh file. Its bytes are never decoded.
struct SurfaceImage {
  std::string name;       // of a file, without folders
  std::string reference;  // as in the file that refers to it; empty if the image is embedded
  std::string mime_type;  // "image/png"; empty if unknown
  std::string bytes;      // empty if the image is missing
};

// A line of a material in MTL. If it refers to an image, the name of that image follows the text.
struct MtlLine {
  std::string text;
  std::optional<uint32_t> image{};  // index of SurfaceLibrary::images
};

// A material as described by the file: in MTL, or as JSON of glTF. Neither if the file only names it.
struct SurfaceMaterial {
  std::vector<MtlLine> mtl;  // after newmtl, in their order
  std::string gltf;          // textures are indices of SurfaceLibrary::textures
  // Transform of the UVs, with v = 0 at the top of an image: of (u, v, 1). See read_uv_transform().
  glm::mat3x2 uv_transform{1, 0, 0, 1, 0, 0};
};

// Materials of a mesh file and their images.
struct SurfaceLibrary {
  std::vector<SurfaceMaterial> materials;  // by material number, i.e. by Soup::materials
  std::vector<SurfaceImage> images;
  std::vector<std::string> textures;             // JSON of glTF; sources are indices of images
  std::vector<std::string> samplers;             // JSON of glTF
  std::vector<std::string> required_extensions;  // of the file
};

}  // namespace kerf
