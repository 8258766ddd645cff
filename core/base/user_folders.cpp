#include "core/base/user_folders.h"

#include <cstdlib>

namespace kerf {

namespace fs = std::filesystem;

namespace {

fs::path folder_by(const char* variable, const char* below_home) {
  const char* named = std::getenv(variable);
  if (named != nullptr && fs::path(named).is_absolute()) return fs::path(named) / "kerf";
  const fs::path home = home_folder();
  return (home.empty() ? fs::path("/") : home) / below_home / "kerf";
}

}  // namespace

fs::path settings_folder() { return folder_by("XDG_CONFIG_HOME", ".config"); }

fs::path state_folder() { return folder_by("XDG_STATE_HOME", ".local/state"); }

fs::path home_folder() {
  const char* home = std::getenv("HOME");
  return home != nullptr ? home : "";
}

}  // namespace kerf
