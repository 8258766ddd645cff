#pragma once

#include <chrono>
#include <vector>

#include "ui/editor/shared/long_change.h"
#include "ui/gl/objects.h"
#include "ui/screen/screen.h"
#include "ui/window/layout.h"

namespace kerf {

// The window while a change is done on a thread of its own and nobody may look at the document: what it
// showed last, under a bar that says how far the change is.
class BusyWindow {
 public:
  // What was drawn to the window and is not swapped yet is shown from this call on; its size in pixels.
  void keep(const Vec2& pixels);
  // Escape and closing the window stop the change; what else the user does waits. Returns whether the window
  // is to be closed. Precondition of this and of draw(): a change is running.
  bool hear(const Input& input, ChangeThread& change);
  // Draws a frame over a window of this size; the bar is there when the change lasts, and its button stops
  // the change.
  void draw(const Vec2& window, const Area& picture, ChangeThread& change) const;
  // What the user did meanwhile, once. After more than a second without what was pressed in the picture: it
  // is another picture by then.
  std::vector<InputEvent> take_heard();

 private:
  using Clock = std::chrono::steady_clock;

  gl::Texture kept_;
  std::vector<InputEvent> heard_;
  Clock::time_point began_;
};

}  // namespace kerf
