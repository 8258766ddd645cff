#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace kerf {

struct EditorOptions {
  // Scenes and meshes that are opened together. Those that cannot be read are left out with an error message;
  // if none can be read, the default scene is shown.
  std::vector<std::filesystem::path> files;
  std::optional<std::filesystem::path> report;  // JSON written at exit, also after SIGINT and SIGTERM
  // JSON of where the named parts of the window are, kept up frame by frame (see landmarks.h), for tests.
  std::optional<std::filesystem::path> landmarks;
  // A script of input that drives the editor without a screen (see event_script.h).
  std::optional<std::filesystem::path> events;
  bool own_font = false;      // ImGui's own font, as where none is installed
  int width = 0, height = 0;  // of the window, in screen coordinates; 0: as in the last session
  std::filesystem::path default_scene;
};

}  // namespace kerf
