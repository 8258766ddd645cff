#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace kerf {

struct FolderEntry {
  std::string name;
  bool folder = false;
  uintmax_t bytes = 0;
};

// Lists the folders in a folder, then the files whose ending says that they can be opened, both by name;
// hidden ones are left out. `fault` becomes a sentence where the folder cannot be read, or empty.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder, std::string& fault);

// Whether a name contains the filter, ignoring case.
bool passes_filter(const std::string& name, const std::string& filter);

}  // namespace kerf
