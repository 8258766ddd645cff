#include "ui/editor/shared/files/example_scenes.h"

#include <algorithm>

#include "core/base/assets.h"

namespace kerf {

namespace fs = std::filesystem;

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

std::string title_of_scene(const fs::path& scene) {
  std::string title = scene.stem().string();
  std::replace(title.begin(), title.end(), '-', ' ');
  if (!title.empty() && title.front() >= 'a' && title.front() <= 'z')
    title.front() = static_cast<char>(title.front() - 'a' + 'A');
  return title;
}

}  // namespace kerf
