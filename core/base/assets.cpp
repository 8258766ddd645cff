#include "core/base/platform.h"

#include <dlfcn.h>

#include <system_error>

namespace kerf {

namespace {

namespace fs = std::filesystem;

// Returns the file of the program or library that contains this code. For a program the linker reports the
// name of its invocation, which need not be a path.
fs::path own_file() {
  Dl_info info{};
  std::error_code fault;
  if (::dladdr(reinterpret_cast<const void*>(&own_file), &info) != 0 && info.dli_fname != nullptr) {
    const fs::path file = info.dli_fname;
    if (file.filename().string().starts_with("libkerf")) return fs::weakly_canonical(file, fault);
  }
  return fs::read_symlink("/proc/self/exe", fault);
}

}  // namespace

fs::path assets_folder() {
  constexpr int kLevels = 4;  // levels above lib/x86_64-linux-gnu, and one to spare
  std::error_code fault;
  fs::path folder = own_file().parent_path();
  for (int level = 0; level < kLevels && !folder.empty(); ++level, folder = folder.parent_path()) {
    const fs::path share = folder / "share/kerf";
    if (fs::is_regular_file(share / "materials.json", fault)) return share;
  }
  return KERF_ASSETS;
}

}  // namespace kerf
