#include "ui/window/open_window.h"

#include "ui/window/desktop_window.h"
#include "ui/window/scripted_window.h"

namespace kerf {

Result<std::unique_ptr<Window>> open_window(const WindowOptions& options) {
  if (options.events) return ScriptedWindow::open(*options.events, options.width, options.height);
  return DesktopWindow::open(options.width, options.height, "Kerf");
}

}  // namespace kerf
