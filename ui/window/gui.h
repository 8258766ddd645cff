#pragma once

#include <optional>

#include "ui/window/theme.h"
#include "ui/window/window.h"

namespace kerf {

// ImGui on a window: its context, its fonts and colours, one frame after the other.
class Gui {
 public:
  explicit Gui(const Window& window);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  // Takes on another look; only between frames. Costs nothing where it is the one it has.
  void dress(const GuiLook& look);

  void begin_frame();
  // Draws over what is in the window.
  void end_frame();

 private:
  std::optional<GuiLook> look_;
};

}  // namespace kerf
