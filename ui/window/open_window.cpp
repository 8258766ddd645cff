#include "ui/window/open_window.h"

#include "ui/window/desktop_window.h"
#include "ui/window/scripted_window.h"

namespace kerf {

Result<std::unique_ptr<Window>> open_window(const WindowOptions& options) {
  if (options.events) {
    auto window = ScriptedWindow::open(*options.events, options.width, options.height);
    if (!window) return window.error();
    return std::unique_ptr<Window>(std::move(*window));
  }
  auto window = DesktopWindow::open(options.width, options.height, "Kerf");
  if (!window) return window.error();
  return std::unique_ptr<Window>(std::move(*window));
}

}  // namespace kerf
