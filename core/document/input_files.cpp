#include "core/document/input_files.h"

#include <sys/stat.h>

#include <charconv>
#include <optional>

#include "core/document/text/json.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

std::optional<struct stat> regular_file(const fs::path& path) {
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0 || !S_ISREG(there.st_mode)) return std::nullopt;
  return there;
}

// Decodes the URI of a glTF file to a path: "%20" is a space.
std::string without_escapes(std::string_view uri) {
  std::string path;
  for (size_t i = 0; i < uri.size(); ++i) {
    unsigned char code = 0;
    const char* const digits = uri.data() + i + 1;
    const bool escaped = uri[i] == '%' && i + 2 < uri.size() &&
                         std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    path += escaped ? static_cast<char>(code) : uri[i];
    if (escaped) i += 2;
  }
  return path;
}

// The files that a glTF file refers to; none if it cannot be read.
std::vector<fs::path> files_of_gltf(const fs::path& file) {
  const auto text = read_text_file(file);
  const auto json = text ? parse_json(*text, "") : Result<nlohmann::json>(text.error());
  std::vector<fs::path> files;
  for (const char* const list : {"buffers", "images"}) {
    if (!json || !json->is_object() || !json->contains(list)) continue;
    for (const nlohmann::json& entry : (*json)[list]) {
      if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
      const auto uri = entry["uri"].get<std::string>();
      if (!uri.starts_with("data:")) files.push_back(file.parent_path() / without_escapes(uri));
    }
  }
  return files;
}

}  // namespace

void InputFiles::add(const fs::path& file) {
  if (const auto there = regular_file(file)) files_.push_back({there->st_dev, there->st_ino, file});
  if (file.extension() != ".gltf") return;
  for (const fs::path& part : files_of_gltf(file)) {
    if (const auto there = regular_file(part)) files_.push_back({there->st_dev, there->st_ino, part});
  }
}

void InputFiles::add_meshes(const SceneDescription& scene) {
  for (const SceneBody& body : scene.bodies) add(body.mesh);
}

void InputFiles::add_meshes(std::span<const Command> commands) {
  for (const Command& command : commands) {
    if (const auto* mesh = std::get_if<AddMesh>(&command)) add(mesh->file);
  }
}

Status InputFiles::check(const std::string& option, const fs::path& output) const {
  const auto there = regular_file(output);
  if (!there) return Done{};
  for (const File& file : files_) {
    if (file.device != there->st_dev || file.inode != there->st_ino) continue;
    const bool same_name = file.path.lexically_normal() == output.lexically_normal();
    return bad_input(option + ": " + output.string() + " would overwrite " +
                     (same_name ? "its own input" : "the input " + file.path.string()) +
                     ": use another path");
  }
  return Done{};
}

Status InputFiles::check_folder(const std::string& option, const fs::path& folder,
                                const std::function<bool(std::string_view)>& is_output) const {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (!is_output(at->path().filename().string())) continue;
    if (const Status free = check(option, at->path()); !free) return free;
  }
  return Done{};
}

InputFiles input_files(std::span<const fs::path> files) {
  InputFiles inputs;
  for (const fs::path& file : files) inputs.add(file);
  return inputs;
}

}  // namespace kerf
