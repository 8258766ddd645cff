#include "ui/editor/files/file_menus.h"

#include "ui/editor/shared/example_scenes.h"

namespace kerf {

namespace fs = std::filesystem;

std::vector<UserAction> recent_actions(Settings& settings, const OpenFile& open) {
  std::vector<UserAction> actions;
  for (const fs::path& file : settings.recent) {
    actions.push_back({.name = file.filename().string(), .tip = file.string()});
    actions.back().run = [open, file] { open(file); };
    actions.back().why_not = [file]() -> const char* {
      std::error_code error;
      return fs::exists(file, error) ? nullptr : "This file is not there any more.";
    };
  }
  if (!actions.empty()) actions.back().ends_group = true;
  actions.push_back({.name = "Forget them", .tip = "Empties this list; the files stay."});
  actions.back().run = [&settings] { settings.recent.clear(); };
  actions.back().why_not = [&settings] {
    return settings.recent.empty() ? "Nothing was opened yet." : nullptr;
  };
  return actions;
}

std::vector<UserAction> example_actions(const OpenFile& open) {
  std::vector<UserAction> actions;
  for (const fs::path& scene : example_scenes()) {
    actions.push_back({.name = title_of_scene(scene), .tip = scene.string()});
    actions.back().run = [open, scene] { open(scene); };
  }
  return actions;
}

}  // namespace kerf
