#include "core/mesh/files/side_file.h"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace kerf {

namespace {

// Returns true for a relative path that stays in the folder from which it starts.
bool leads_inside(const std::filesystem::path& path) {
  const bool has_drive = path.string().find(':') != std::string::npos;
  return !path.empty() && !path.is_absolute() && !has_drive &&
         std::none_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
}

}  // namespace

std::string side_file_name(std::string_view reference) {
  return std::string(reference.substr(reference.find_last_of("/\\") + 1));
}

std::optional<std::filesystem::path> side_file(const std::filesystem::path& folder,
                                               std::string_view reference) {
  if (reference.find('\0') != std::string_view::npos) return std::nullopt;
  std::string path(reference);
  std::replace(path.begin(), path.end(), '\\', '/');
  const std::string name = side_file_name(path);
  if (name.empty() || name == "." || name == "..") return std::nullopt;
  std::error_code fault;
  const std::filesystem::path file = folder / (leads_inside(path) ? path : name);
  return std::filesystem::is_regular_file(file, fault) ? file : folder / name;
}

Result<std::string> read_side_file(const std::filesystem::path& folder, std::string_view reference,
                                   size_t max_bytes) {
  namespace fs = std::filesystem;
  if (folder.empty() || reference.find('\0') != std::string_view::npos) return bad_input("is not read");
  const auto file = side_file(folder, reference);
  if (!file) return bad_input("names no file");
  std::error_code fault;
  if (!fs::is_regular_file(*file, fault)) return bad_input("is not in the folder of this file");
  const auto size = fs::file_size(*file, fault);
  if (fault || size > max_bytes) return bad_input("is too large");
  std::string bytes(static_cast<size_t>(size), '\0');
  std::ifstream in(*file, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in) return bad_input("cannot be read");
  return bytes;
}

}  // namespace kerf
