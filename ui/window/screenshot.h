#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "ui/window/layout.h"

namespace kerf {

// Writes a part of the window (in pixels of the framebuffer, from its upper left corner) to a PNG file that
// is named by date and time, in the current folder or, if that is not writable, in ~/Pictures. Returns the
// path of the file.
Result<std::filesystem::path> take_screenshot(Vec2 window, const Area& part);

}  // namespace kerf
