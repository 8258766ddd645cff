#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/result.h"
#include "ui/window/window.h"

namespace kerf {

// The window that a program asks for.
struct WindowOptions {
  int width = 0, height = 0;  // screen coordinates
  std::optional<std::filesystem::path>
      events;  // a script that drives it without a screen (see event_script.h)
};

// Opens a window on the desktop, or one that a script drives. Fails if there is no display or no OpenGL 3.3,
// or if the script cannot be read.
Result<std::unique_ptr<Window>> open_window(const WindowOptions& options);

}  // namespace kerf
