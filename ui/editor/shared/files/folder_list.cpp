#include "ui/editor/shared/files/folder_list.h"

#include <cctype>

#include "core/document/journal/opened_file.h"
#include "core/mesh/files/mesh_format.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool can_be_opened(const fs::path& file) {
  const std::string ending = lower(file.extension().string());
  return ending == ".json" || is_journal(file) || mesh_format(ending).has_value();
}

}  // namespace

std::vector<FolderEntry> list_folder(const fs::path& folder, std::string& fault) {
  fault.clear();
  std::vector<FolderEntry> entries;
  std::error_code error;
  fs::directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with('.')) continue;
    std::error_code unknown;
    if (at->is_directory(unknown)) {
      entries.push_back({name, true, 0});
    } else if (at->is_regular_file(unknown) && can_be_opened(at->path())) {
      const uintmax_t bytes = at->file_size(unknown);
      entries.push_back({name, false, unknown ? 0 : bytes});
    }
  }
  if (error) fault = folder.string() + ": this folder cannot be read";
  std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
    if (a.folder != b.folder) return a.folder;
    const std::string low_a = lower(a.name), low_b = lower(b.name);
    return low_a != low_b ? low_a < low_b : a.name < b.name;
  });
  return entries;
}

bool passes_filter(const std::string& name, const std::string& filter) {
  return lower(name).find(lower(filter)) != std::string::npos;
}

}  // namespace kerf
