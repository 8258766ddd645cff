#include "ui/window/window.h"

#include "ui/window/desktop_window.h"
#include "ui/window/scripted_window.h"

namespace kerf {

Area pixels_of(const Area& area, const Window& window) {
  const Vec2 scale = window.pixel_size() / window.size();
  const Vec2 from = glm::floor(area.at * scale), to = glm::floor((area.at + area.size) * scale);
  return {from, glm::max(Vec2(1), to - from)};
}

Result<std::unique_ptr<Window>> open_window(const WindowOptions& options) {
  if (options.events) return ScriptedWindow::open(*options.events, options.width, options.height);
  return DesktopWindow::open(options.width, options.height, "Kerf");
}

}  // namespace kerf
