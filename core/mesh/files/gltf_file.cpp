#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <numeric>
#include <system_error>

#include "core/mesh/files/bytes.h"
#include "core/mesh/files/gltf_file_internal.h"
#include "core/mesh/files/scanner.h"

namespace kerf {

namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

int digit_of(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

}  // namespace

std::string to_base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::optional<std::string> from_base64(std::string_view text) {
  for (int pads = 0; pads < 2 && text.ends_with('='); ++pads) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    const int digit = digit_of(c);
    if (digit < 0) return std::nullopt;
    group = (group << 6 | static_cast<uint32_t>(digit)) & 0xffffff;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 0xff);
  }
  return bytes;
}

namespace {

namespace fs = std::filesystem;

constexpr size_t kHead = 12, kChunkHead = 8;
constexpr uint64_t kMaxBuffer = uint64_t{1} << 32;
constexpr std::array<const char*, 7> kLists{"accessors", "bufferViews", "buffers", "materials",
                                            "meshes",    "nodes",       "scenes"};

uint32_t word_at(std::string_view bytes, size_t at) {
  return load<uint32_t>(bytes.data() + at, std::endian::little);
}

// Returns true for extensions that change the look of a mesh but not its geometry.
bool changes_looks_only(std::string_view extension) {
  constexpr std::array<std::string_view, 6> kPrefixes{"KHR_materials_", "KHR_texture_", "KHR_lights_",
                                                      "EXT_texture_",   "KHR_xmp",      "EXT_lights_"};
  return std::any_of(kPrefixes.begin(), kPrefixes.end(),
                     [&](std::string_view prefix) { return extension.starts_with(prefix); });
}

// Returns true if a path stays in the folder from which it starts.
bool stays_inside(const fs::path& path) {
  return !path.is_absolute() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& p) { return p == ".."; });
}

}  // namespace

std::optional<std::string> decoded_path(std::string_view uri) {
  std::string path;
  for (size_t i = 0; i < uri.size(); ++i) {
    char c = uri[i];
    if (c == '%') {
      const auto digit = [](char d) {
        if (d >= '0' && d <= '9') return d - '0';
        const char low = static_cast<char>(d | 0x20);
        return low >= 'a' && low <= 'f' ? low - 'a' + 10 : -1;
      };
      if (i + 2 >= uri.size() || digit(uri[i + 1]) < 0 || digit(uri[i + 2]) < 0) return std::nullopt;
      c = static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2]));
      i += 2;
    }
    if (c == '\0') return std::nullopt;
    path += c;
  }
  return path;
}

bool GltfFile::is_binary(std::string_view bytes) {
  return bytes.size() >= 4 && word_at(bytes, 0) == kGlbMagic;
}

Result<GltfFile> GltfFile::open(std::string_view bytes, const std::string& name, const fs::path& folder) {
  GltfFile file;
  file.name_ = one_line(name);
  auto problem = is_binary(bytes) ? file.take_chunks(bytes) : file.parse(bytes);
  if (!problem) problem = file.check_version();
  if (!problem) problem = file.check_lists();
  if (!problem) problem = file.check_extensions();
  if (!problem) problem = file.find_buffers(folder);
  if (problem) return *problem;
  return file;
}

Error GltfFile::wrong(const std::string& where, const std::string& what) const {
  return bad_input(name_ + ": " + where + ": " + what + ".");
}

std::optional<Error> GltfFile::take_chunks(std::string_view bytes) {
  if (bytes.size() < kHead + kChunkHead)
    return wrong("byte 0", "the file ends within the header of a binary glTF file");
  if (word_at(bytes, 4) != kGlbVersion) return other_version("byte 4", std::to_string(word_at(bytes, 4)));
  const size_t length = word_at(bytes, 8);
  if (length > bytes.size() || length < kHead + kChunkHead) {
    return wrong("byte 8", "declares " + std::to_string(length) + " bytes, but the file has " +
                               std::to_string(bytes.size()));
  }
  std::string_view text;
  for (size_t at = kHead, chunk = 0; at + kChunkHead <= length; ++chunk) {
    const size_t size = word_at(bytes, at);
    const uint32_t kind = word_at(bytes, at + 4);
    if (size > length - at - kChunkHead) {
      return wrong("byte " + std::to_string(at), "declares a chunk of " + std::to_string(size) +
                                                     " bytes, but only " +
                                                     std::to_string(length - at - kChunkHead) + " follow");
    }
    const std::string_view content = bytes.substr(at + kChunkHead, size);
    if (chunk == 0 && kind != kGlbJson)
      return wrong("byte " + std::to_string(at + 4), "the first chunk is not JSON");
    if (chunk == 0) text = content;
    if (chunk == 1 && kind == kGlbBinary) binary_ = content;
    at += kChunkHead + size + (4 - size % 4) % 4;
  }
  return parse(text);
}

std::optional<Error> GltfFile::parse(std::string_view text) {
  try {
    json_ = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& fault) {
    return wrong("byte " + std::to_string(fault.byte) + " of the JSON", "syntax error");
  } catch (const nlohmann::json::exception&) {
    return wrong("JSON", "it has a number that is too large");
  }
  if (!json_.is_object()) return wrong("JSON", "must be an object");
  return std::nullopt;
}

std::optional<Error> GltfFile::check_lists() const {
  for (const char* list : kLists) {
    if (!json_.contains(list)) continue;
    const nlohmann::json& elements = json_[list];
    const auto is_object = [](const nlohmann::json& e) { return e.is_object(); };
    if (!elements.is_array() || !std::all_of(elements.begin(), elements.end(), is_object))
      return wrong(std::string("/") + list, "must be an array of objects");
  }
  return std::nullopt;
}

Error GltfFile::other_version(const std::string& where, const std::string& version) const {
  return wrong(where, "this is glTF " + version + ", but only glTF 2.0 is supported; convert it to 2.0");
}

std::optional<Error> GltfFile::check_version() const {
  const auto text = [&](const char* key) -> std::string {
    const auto asset = json_.find("asset");
    if (asset == json_.end() || !asset->is_object()) return "";
    const auto at = asset->find(key);
    if (at == asset->end()) return "";
    return at->is_string() ? one_line(at->get<std::string>()) : at->is_number() ? at->dump() : "";
  };
  const bool has_least = !text("minVersion").empty();
  const std::string version = has_least ? text("minVersion") : text("version");
  // Before 2.0 the accessors and other elements had names, and the version was optional.
  const bool named = std::any_of(kLists.begin(), kLists.end(), [&](const char* list) {
    return json_.contains(list) && json_[list].is_object();
  });
  if (version.empty() && named) return other_version("/accessors", "1.0");
  if (version.empty()) return wrong("/asset/version", "is missing; this is not a glTF file");
  if (!(has_least ? version == "2.0" : version.starts_with("2.")) && version != "2")
    return other_version(has_least ? "/asset/minVersion" : "/asset/version", version);
  return std::nullopt;
}

std::optional<Error> GltfFile::check_extensions() const {
  const auto required = json_.find("extensionsRequired");
  if (required == json_.end()) return std::nullopt;
  if (!required->is_array()) return wrong("/extensionsRequired", "must be an array");
  for (const nlohmann::json& extension : *required) {
    if (!extension.is_string()) return wrong("/extensionsRequired", "must be an array of strings");
    const auto name = extension.get<std::string>();
    if (changes_looks_only(name) || name == "KHR_mesh_quantization" || name == kGltfInstancing) continue;
    return wrong("/extensionsRequired", in_quotes(name) + " is not supported; export the file without it");
  }
  return std::nullopt;
}

const nlohmann::json* GltfFile::find_element(const char* list, uint64_t i) const {
  const auto at = json_.find(list);
  if (at == json_.end() || !at->is_array() || i >= at->size() || !(*at)[i].is_object()) return nullptr;
  return &(*at)[i];
}

size_t GltfFile::count(const char* list) const {
  const auto at = json_.find(list);
  return at == json_.end() ? 0 : at->size();
}

Result<uint64_t> GltfFile::whole(const nlohmann::json& of, const char* key, uint64_t missing,
                                 const std::string& where) const {
  constexpr uint64_t kMost = uint64_t{1} << 53;
  const auto at = of.find(key);
  if (at == of.end()) return missing;
  if (at->is_number_unsigned() && at->get<uint64_t>() <= kMost) return at->get<uint64_t>();
  if (at->is_number_float()) {
    const double number = at->get<double>();
    if (number >= 0 && number <= static_cast<double>(kMost) &&
        number == static_cast<double>(static_cast<uint64_t>(number)))
      return static_cast<uint64_t>(number);
  }
  return wrong(where + "/" + key, "must be a whole number");
}

Result<std::optional<uint32_t>> GltfFile::index(const nlohmann::json& of, const char* key, const char* list,
                                                const std::string& where) const {
  if (!of.contains(key)) return std::optional<uint32_t>();
  const auto number = whole(of, key, 0, where);
  if (!number) return number.error();
  if (*number >= count(list)) {
    return wrong(where + "/" + key, "refers to element " + std::to_string(*number) + " of /" + list +
                                        ", which has " + std::to_string(count(list)));
  }
  return std::optional(static_cast<uint32_t>(*number));
}

std::optional<Error> GltfFile::find_buffers(const fs::path& folder) {
  owned_.reserve(count("buffers"));  // keeps the views into its elements valid
  for (size_t i = 0; i < count("buffers"); ++i) {
    const std::string where = "/buffers/" + std::to_string(i);
    const auto length = whole(element("buffers", i), "byteLength", 0, where);
    if (!length) return length.error();
    const auto bytes = buffer_bytes(i, folder);
    if (!bytes) return bytes.error();
    if (*length > bytes->size()) {
      return wrong(where + "/byteLength", "declares " + std::to_string(*length) + " bytes, but there are " +
                                              std::to_string(bytes->size()));
    }
    buffers_.push_back(bytes->substr(0, *length));
  }
  return std::nullopt;
}

Result<std::string_view> GltfFile::buffer_bytes(size_t i, const fs::path& folder) {
  const std::string where = "/buffers/" + std::to_string(i) + "/uri";
  const nlohmann::json& buffer = element("buffers", i);
  const auto at = buffer.find("uri");
  if (at == buffer.end()) {
    if (i == 0) return binary_;
    return wrong("/buffers/" + std::to_string(i), "has no uri");
  }
  if (!at->is_string()) return wrong(where, "must be a string");
  const auto& uri = at->get_ref<const std::string&>();
  if (uri.starts_with("data:")) {
    const size_t comma = uri.find(";base64,");
    auto bytes =
        comma == std::string::npos ? std::nullopt : from_base64(std::string_view(uri).substr(comma + 8));
    if (!bytes) return wrong(where, "is not base64 data");
    return std::string_view(owned_.emplace_back(std::move(*bytes)));
  }
  const auto path = decoded_path(uri);
  if (uri.find("://") != std::string::npos || !path || path->empty())
    return wrong(where, in_quotes(uri) + " is not a file path; buffers must be in the folder of this file");
  if (folder.empty() || !stays_inside(*path))
    return wrong(where, in_quotes(uri) + " is outside the folder of this file and is not read");
  const fs::path file = folder / *path;
  std::error_code fault;
  if (!fs::is_regular_file(file, fault))
    return wrong(where, "there is no file " + in_quotes(*path) + " in the folder of this file");
  if (fs::file_size(file, fault) > kMaxBuffer)
    return wrong(where, in_quotes(*path) + " exceeds the limit of 4 GiB");
  std::ifstream in(file, std::ios::binary);
  owned_.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  if (!in.good() && !in.eof()) return wrong(where, in_quotes(*path) + " cannot be read");
  return std::string_view(owned_.back());
}

uint64_t GltfFile::buffer_bytes() const {
  return std::accumulate(buffers_.begin(), buffers_.end(), uint64_t{0},
                         [](uint64_t sum, std::string_view buffer) { return sum + buffer.size(); });
}

Result<GltfFile::View> GltfFile::view(uint32_t i) const {
  const std::string where = "/bufferViews/" + std::to_string(i);
  const nlohmann::json& json = element("bufferViews", i);
  const auto buffer = index(json, "buffer", "buffers", where);
  if (!buffer) return buffer.error();
  if (!*buffer) return wrong(where + "/buffer", "is missing");
  const auto offset = whole(json, "byteOffset", 0, where), length = whole(json, "byteLength", 0, where),
             stride = whole(json, "byteStride", 0, where);
  for (const auto* number : {&offset, &length, &stride}) {
    if (!*number) return number->error();
  }
  const std::string_view bytes = buffers_[**buffer];
  if (*offset > bytes.size() || *length > bytes.size() - *offset) {
    return wrong(where, "reaches to byte " + std::to_string(*offset + *length) + " of a buffer of " +
                            std::to_string(bytes.size()));
  }
  return View{bytes.substr(*offset, *length), *stride};
}

}  // namespace kerf
