#pragma once

#include <chrono>
#include <vector>

#include "ui/editor/editor_state.h"
#include "ui/gl/objects.h"
#include "ui/window/gui.h"
#include "ui/window/window.h"

namespace kerf {

// The window while long work is done and nobody may look at the document: what it showed last, under a bar
// that says how far the work is.
class BusyWindow {
 public:
  // What was drawn to the window and is not swapped yet is shown from now on; its size in pixels.
  void keep(const Vec2& pixels);
  // A frame; the bar is there when the work lasts. Escape, the button beside the bar and closing the window
  // stop the work; what else the user does waits.
  void show(EditorState& state, Window& window, Gui& gui);
  // What the user did meanwhile, once. After more than a second without what was pressed in the picture: it
  // is another picture by now.
  std::vector<InputEvent> take_heard();

 private:
  using Clock = std::chrono::steady_clock;

  void hear(EditorState& state, Window& window);
  void draw_kept(const Vec2& size) const;

  gl::Texture kept_;
  std::vector<InputEvent> heard_;
  Clock::time_point began_;
};

}  // namespace kerf
