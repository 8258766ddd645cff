#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/result.h"

namespace kerf {

struct EditorOptions {
  // Scenes and meshes, opened together; where one is bad, the default scene is shown and the reason said.
  std::vector<std::filesystem::path> files;
  std::optional<std::filesystem::path> report;  // JSON written at exit, also on SIGINT and SIGTERM
  // JSON of where the named parts of the window are, kept up frame by frame (see landmarks.h), for tests.
  std::optional<std::filesystem::path> landmarks;
  bool own_font = false;      // ImGui's own font, as where none is installed
  int width = 0, height = 0;  // of the window, in screen coordinates; 0: as it was the last time
  std::filesystem::path default_scene;
};

// The editor, from its window opening to its window closing. Fails where there is no display or no
// OpenGL 3.3, where not even the default scene can be read, or where the report cannot be written.
Status run_editor(const EditorOptions& options);

}  // namespace kerf
