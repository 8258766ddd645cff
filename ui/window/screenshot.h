#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "ui/render/picture/png.h"
#include "ui/window/layout.h"

namespace kerf {

// A part of the window (in pixels of the framebuffer, from its upper left corner) as it is drawn so far.
Pixels window_pixels(Vec2 window, const Area& part);

// Writes a part of the window to a PNG file that is named by date and time, in the current folder or, if that
// is not writable, in ~/Pictures. Returns the path of the file.
Result<std::filesystem::path> take_screenshot(Vec2 window, const Area& part);

}  // namespace kerf
