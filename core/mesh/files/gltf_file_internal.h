#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/json.h"
#include "core/base/result.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {

// Magic number and version of a binary glTF file and the types of its chunks, as little-endian words.
inline constexpr uint32_t kGlbMagic = 0x46546C67, kGlbVersion = 2, kGlbJson = 0x4E4F534A,
                          kGlbBinary = 0x004E4942;

// The component types of accessors: unsigned integers and float.
inline constexpr uint64_t kGltfByte = 5121, kGltfShort = 5123, kGltfInt = 5125, kGltfFloat = 5126;
inline constexpr uint64_t kGltfSignedByte = 5120, kGltfSignedShort = 5122;

inline constexpr const char* kGltfInstancing = "EXT_mesh_gpu_instancing";

// Encodes bytes in base 64 (RFC 4648), with padding.
std::string to_base64(std::string_view bytes);

// Decodes such a text, whose padding may be missing; nullopt if it is malformed.
std::optional<std::string> from_base64(std::string_view text);

// Returns the path of a URI with percent-encoding decoded; nullopt if it is malformed or has a zero byte.
std::optional<std::string> decoded_path(std::string_view uri);

// The JSON of a glTF 2.0 file and the bytes of its buffers, with validating access.
class GltfFile {
 public:
  // Returns true if the bytes begin like a binary glTF file.
  static bool is_binary(std::string_view bytes);

  // Parses a .glb or .gltf. Buffers in other files are read only if these are in `folder` or below; if
  // `folder` is empty, none are read. Fails with one sentence that names the file if this is no glTF 2.0
  // file, ends too early, or requires unsupported extensions for geometry. `bytes` must outlive the result.
  static Result<GltfFile> open(std::string_view bytes, const std::string& name,
                               const std::filesystem::path& folder);

  const nlohmann::json& root() const { return json_; }
  // Returns an element of a list of the root that may be malformed; null if there is no such object.
  const nlohmann::json* find_element(const char* list, uint64_t i) const;
  // Returns the length of a list of the root, 0 if it is missing.
  size_t count(const char* list) const;
  // Returns an element. Precondition: i < count(list).
  const nlohmann::json& element(const char* list, size_t i) const { return json_[list][i]; }

  // Reads a member that is an index of an element of `list`; nullopt if there is no such member.
  Result<std::optional<uint32_t>> index(const nlohmann::json& of, const char* key, const char* list,
                                        const std::string& where) const;
  // Reads a member that is a whole number, at most 2^53; `missing` if there is none.
  Result<uint64_t> whole(const nlohmann::json& of, const char* key, uint64_t missing,
                         const std::string& where) const;

  // The bytes of a buffer view, and the stride of its elements, 0 if it has none.
  struct View {
    std::string_view bytes;
    uint64_t stride = 0;
  };
  Result<View> view(uint32_t i) const;
  // Returns the number of bytes of all buffers.
  uint64_t buffer_bytes() const;

  // "FILE: WHERE: WHAT."
  Error wrong(const std::string& where, const std::string& what) const;

 private:
  GltfFile() = default;

  std::optional<Error> take_chunks(std::string_view bytes);
  std::optional<Error> parse(std::string_view text);
  std::optional<Error> check_version() const;
  std::optional<Error> check_lists() const;
  Error other_version(const std::string& where, const std::string& version) const;
  std::optional<Error> check_extensions() const;
  std::optional<Error> find_buffers(const std::filesystem::path& folder);
  Result<std::string_view> buffer_bytes(size_t i, const std::filesystem::path& folder);

  std::string name_;
  nlohmann::json json_;
  std::string_view binary_;                // the second chunk
  std::vector<std::string> owned_;         // of buffers in other files and in data URIs
  std::vector<std::string_view> buffers_;  // by index
};

// The elements of an accessor of a glTF file: rows of numbers in a buffer, with those that a sparse accessor
// replaces. All functions fail if the accessor has another type or if the buffer ends too early.
class GltfAccessor {
 public:
  // Indices: one unsigned whole number each.
  static Result<GltfAccessor> indices(const GltfFile& file, uint32_t accessor);

  // Vectors of one to four floats, or of whole numbers of 8 or 16 bits (KHR_mesh_quantization). Normalised
  // whole numbers are fractions of the largest one.
  static Result<GltfAccessor> vectors(const GltfFile& file, uint32_t accessor, size_t parts);
  // Likewise with the number of parts that the accessor has.
  static Result<GltfAccessor> vectors(const GltfFile& file, uint32_t accessor);

  // Colours: three or four floats or normalised whole numbers each.
  static Result<GltfAccessor> colours(const GltfFile& file, uint32_t accessor);

  size_t size() const { return size_; }
  size_t parts() const { return parts_; }  // of a colour or a vector
  // Precondition of each: i < size(), and the accessor is of this kind.
  VertexColour colour(size_t i) const;  // converted from linear light to sRGB
  glm::dvec4 vector(size_t i) const;    // with zero for a missing part
  uint32_t index(size_t i) const;

 private:
  // The type of an accessor: "VEC3" and so on, and the bytes of an element.
  struct Row {
    const char* type;
    uint64_t bytes;
  };
  static Result<GltfAccessor> rows(const GltfFile& file, uint32_t accessor, const Row& row);
  static Result<GltfAccessor> dense_rows(const GltfFile& file, const nlohmann::json& json,
                                         const std::string& where, const Row& row);
  // Replaces the rows that the member "sparse" lists.
  std::optional<Error> replace_sparse(const GltfFile& file, const nlohmann::json& sparse,
                                      const std::string& where, const Row& row);

  std::string_view bytes_;
  std::shared_ptr<const std::string> owned_;  // the bytes of a sparse accessor
  size_t size_ = 0, stride_ = 0, width_ = 0;
  size_t parts_ = 0;
  uint64_t component_ = 0;  // of a vector
  bool is_normalised_ = false;
};

using GltfMatrix = glm::dmat4;

// Returns the transform of a node to its parent. `where` names it in errors.
Result<GltfMatrix> gltf_transform(const GltfFile& file, const nlohmann::json& node, const std::string& where);

// Returns the transforms of the instances of a node's mesh to the scene (EXT_mesh_gpu_instancing); that of
// the node, `to_scene`, without the extension. Fails for instances that are not finite, and for more than
// `max_instances`.
Result<std::vector<GltfMatrix>> gltf_instances(const GltfFile& file, const nlohmann::json& node,
                                               const std::string& where, const GltfMatrix& to_scene,
                                               size_t max_instances);

}  // namespace kerf
