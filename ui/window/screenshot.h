#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "ui/window/layout.h"

namespace kerf {

// Writes what stands in a part of the window (pixels of the framebuffer, from its upper left corner) to a PNG
// file that is named by date and time, in the current folder or, where that cannot be written, in ~/Pictures.
// Returns where it went.
Result<std::filesystem::path> take_screenshot(Vec2 window, const Area& part);

}  // namespace kerf
