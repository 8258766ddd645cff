#pragma once

#include <optional>
#include <span>

#include "ui/window/theme.h"
#include "ui/window/window.h"

namespace kerf {

// Lets the mouse keep the slider or the button that it holds, in a frame that leaves the panels out;
// otherwise ImGui lets go of an item that a frame does not draw. To be called within each such frame.
void keep_active_item();

// Runs ImGui in a window: its context, its fonts and colours, and its frames.
class Gui {
 public:
  // The window must outlive it. Precondition: there is no other ImGui context.
  explicit Gui(Window& window);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  // Changes the look; costs nothing if it is the current one. Precondition: called between frames.
  void dress(const GuiLook& look);

  // `events` are those that the window received since the last frame. Each frame that begins ends before the
  // next one.
  void begin_frame(std::span<const InputEvent> events);
  // Draws the panels over the content of the window.
  void end_frame();

 private:
  void hold_release(std::span<const InputEvent> events);

  Window& window_;
  std::optional<GuiLook> look_;
  std::optional<Vec2>
      released_;  // where the left button was released while the item that it holds was hidden
  float last_frame_seconds_ = 0;
};

}  // namespace kerf
