#include "ui/editor/frame/file_menus.h"

#include <imgui.h>

#include "ui/render/assets.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> example_scenes() {
  std::vector<fs::path> scenes;
  std::error_code error;
  fs::directory_iterator at(assets_folder() / "scenes", error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    if (at->path().extension() == ".json") scenes.push_back(at->path());
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

void draw_recent_menu(Settings& settings, Requests& requests) {
  std::vector<fs::path>& recent = settings.recent;
  if (recent.empty()) ImGui::TextDisabled("Nothing was opened yet");
  for (size_t i = 0; i < recent.size(); ++i) {
    std::error_code error;
    const bool there = fs::exists(recent[i], error);
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::MenuItem(recent[i].filename().c_str(), nullptr, false, there)) requests.open = {recent[i]};
    tooltip(there ? recent[i].c_str() : (recent[i].string() + " is not there any more").c_str());
    ImGui::PopID();
  }
  if (recent.empty()) return;
  ImGui::Separator();
  if (ImGui::MenuItem("Forget them")) recent.clear();
}

void draw_examples_menu(Requests& requests) {
  for (const fs::path& scene : example_scenes()) {
    if (ImGui::MenuItem(title_of(scene).c_str())) requests.open = {scene};
    tooltip(scene.c_str());
  }
}

}  // namespace kerf
