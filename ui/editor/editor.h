#pragma once

#include <filesystem>
#include <optional>

#include "core/base/result.h"

namespace kerf {

struct EditorOptions {
  std::optional<std::filesystem::path>
      file;  // a scene or a mesh; a bad one shows the default scene and says why
  std::optional<std::filesystem::path> report;  // JSON written at exit, also on SIGINT and SIGTERM
  int width = 1280, height = 800;               // of the window, in screen coordinates
  std::filesystem::path default_scene;
};

// The editor, from its window opening to its window closing. Fails where there is no display or no
// OpenGL 3.3, where not even the default scene can be read, or where the report cannot be written.
Status run_editor(const EditorOptions& options);

}  // namespace kerf
