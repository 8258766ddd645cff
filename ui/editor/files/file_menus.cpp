#include "ui/editor/files/file_menus.h"

#include "ui/render/bodies/assets.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

// Those of the figures of the paper are many, and few of them are good to begin with.
std::vector<fs::path> example_scenes() {
  std::vector<fs::path> scenes;
  std::error_code error;
  fs::directory_iterator at(assets_folder() / "scenes", error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    const bool of_figures = at->path().stem().string().starts_with("figure-");
    if (at->path().extension() == ".json" && !of_figures) scenes.push_back(at->path());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

// "thin-plate.json" as "Thin plate".
std::string title_of(const fs::path& scene) {
  std::string title = scene.stem().string();
  std::replace(title.begin(), title.end(), '-', ' ');
  if (!title.empty() && title.front() >= 'a' && title.front() <= 'z')
    title.front() = static_cast<char>(title.front() - 'a' + 'A');
  return title;
}

}  // namespace

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
    actions.push_back({.name = title_of(scene), .tip = scene.string()});
    actions.back().run = [open, scene] { open(scene); };
  }
  return actions;
}

}  // namespace kerf
