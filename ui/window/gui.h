#pragma once

#include <optional>
#include <span>

#include "ui/window/gui_input.h"
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

  // Begins a frame and returns its events: those that the window received and that one frame can show in
  // their order (see GuiInput). Each frame that begins ends before the next one.
  std::vector<InputEvent> begin_frame(KeyboardHold hold);
  // Whether events wait for the next frame.
  bool input_waits() const { return input_.waits(); }
  // Draws the panels over the content of the window.
  void end_frame();

 private:
  void hold_release(std::span<const InputEvent> events);

  Window& window_;
  GuiInput input_;
  std::optional<GuiLook> look_;
  std::optional<Vec2>
      released_;  // where the left button was released while the item that it holds was hidden
  float last_frame_seconds_ = 0;
};

}  // namespace kerf
