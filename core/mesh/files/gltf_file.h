#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace kerf {

// The JSON of a glTF 2.0 file and the bytes of its buffers, with access that checks what it reads.
class GltfFile {
 public:
  // Whether the bytes begin like a binary glTF file.
  static bool is_binary(std::string_view bytes);

  // Takes a .glb or a .gltf apart. Buffers in other files are read if these lie in `folder` or below; without
  // a folder there are none. Fails with one sentence that names the file for what is no glTF 2.0, what ends
  // too early, and extensions without which the geometry would be wrong. `bytes` must outlive the result.
  static Result<GltfFile> open(std::string_view bytes, const std::string& name,
                               const std::filesystem::path& folder);

  const nlohmann::json& root() const { return json_; }
  // The elements of a list of the root; none if it is missing.
  size_t count(const char* list) const;
  // An element. Precondition: i < count(list).
  const nlohmann::json& element(const char* list, size_t i) const { return json_[list][i]; }

  // A member that is an index of an element of `list`; nothing if there is no such member.
  Result<std::optional<uint32_t>> index(const nlohmann::json& of, const char* key, const char* list,
                                        const std::string& where) const;
  // A member that is a whole number, at most 2^53; `missing` if there is none.
  Result<uint64_t> whole(const nlohmann::json& of, const char* key, uint64_t missing,
                         const std::string& where) const;

  // The bytes of a buffer view, and the distance of its elements, 0 if it says none.
  struct View {
    std::string_view bytes;
    uint64_t stride = 0;
  };
  Result<View> view(uint32_t i) const;

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

}  // namespace kerf
