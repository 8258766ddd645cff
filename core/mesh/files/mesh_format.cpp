#include "core/mesh/files/mesh_format.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/base/assert.h"
#include "core/mesh/files/gltf_file.h"
#include "core/mesh/files/off_reader.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/stl_reader.h"

namespace kerf {
namespace {

// In the order of MeshFormat.
constexpr std::array<std::string_view, 6> kNames{"obj", "ply", "stl", "off", "glb", "gltf"};

constexpr std::array<std::string_view, 13> kObjKeywords{"v", "vt",     "vn",     "vp", "f", "g", "o",
                                                        "s", "usemtl", "mtllib", "l",  "p", "mg"};

// Comments and blanks before the first word of a text file are searched up to this many bytes.
constexpr size_t kLongestPreface = 1 << 20;

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
  return result;
}

std::optional<MeshFormat> format_of_first_word(std::string_view bytes) {
  Scanner scanner(bytes.substr(0, kLongestPreface), {}, {.comments = true, .continuations = false}, nullptr);
  scanner.at_end();
  const std::string_view word = scanner.word();
  if (word == "ply") return MeshFormat::kPly;
  if (is_off_keyword(word)) return MeshFormat::kOff;
  if (lower(word) == "solid") return MeshFormat::kStl;
  if (std::find(kObjKeywords.begin(), kObjKeywords.end(), word) != kObjKeywords.end())
    return MeshFormat::kObj;
  return std::nullopt;
}

// An object of JSON with the member that every glTF file has.
bool is_gltf_text(std::string_view bytes) {
  const size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{' &&
         bytes.find("\"asset\"") != std::string_view::npos;
}

}  // namespace

std::optional<MeshFormat> mesh_format(std::string_view name) {
  if (name.starts_with('.')) name.remove_prefix(1);
  const auto found = std::find(kNames.begin(), kNames.end(), lower(name));
  if (found == kNames.end()) return std::nullopt;
  return static_cast<MeshFormat>(found - kNames.begin());
}

std::string_view format_name(MeshFormat format) {
  KERF_ASSERT(static_cast<size_t>(format) < kNames.size());
  return kNames[static_cast<size_t>(format)];
}

std::optional<MeshFormat> recognise_format(std::string_view bytes, std::string_view ending) {
  if (GltfFile::is_binary(bytes)) return MeshFormat::kGlb;
  if (is_exact_binary_stl(bytes)) return MeshFormat::kStl;
  if (is_gltf_text(bytes)) return MeshFormat::kGltf;
  const std::optional<MeshFormat> by_content = format_of_first_word(bytes);
  return by_content ? by_content : mesh_format(ending);
}

}  // namespace kerf
