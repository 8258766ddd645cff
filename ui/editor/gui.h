#pragma once

#include "ui/editor/window.h"

namespace kerf {

// ImGui on a window: its context, its fonts and colours, one frame after the other.
class Gui {
 public:
  explicit Gui(const Window& window);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  void begin_frame();
  // Draws over what is in the window.
  void end_frame();
};

}  // namespace kerf
