#include "ui/editor/editor.h"

#include "ui/editor/editor_report.h"
#include "ui/editor/editor_screen.h"
#include "ui/gl/debug_output.h"
#include "ui/screen/frame_loop.h"

namespace kerf {

Status run_editor(const EditorOptions& options) {
  LoadedSettings loaded = read_settings(settings_file());
  const std::string fault = loaded.fault;
  const int width = options.width > 0 ? options.width : loaded.settings.width;
  const int height = options.height > 0 ? options.height : loaded.settings.height;
  auto window = Window::open(width, height, "Kerf");
  if (!window) return window.error();
  gl::report_gl_errors();
  auto picture = LivePicture::create();
  if (!picture) return picture.error();
  Gui gui(*window);
  FrameLoop loop(*window, gui);
  EditorScreen screen(*window, std::move(*picture), std::move(loaded), options);
  gui.dress(screen.look());
  if (const Status opened = screen.open(); !opened) return opened;
  screen.tell(fault);
  screen.close(loop.run(screen));
  if (!options.report) return Done{};
  return write_editor_report(screen.state(), *options.report);
}

}  // namespace kerf
