#pragma once

#include <filesystem>
#include <vector>

#include "ui/window/gui_look.h"
#include "ui/window/window.h"

namespace kerf {

// What the user did in the window since the last frame.
struct Input {
  std::vector<InputEvent> events;
  std::vector<std::filesystem::path> drops;  // files that were dropped on the window
  bool close = false;                        // the user asked to close the window
};

// What a frame took, seconds.
struct FrameTime {
  double whole = 0;   // of the frame, without waiting for it to begin
  double before = 0;  // from its beginning until it was handed to the display
};

// What the window shows and the user works in: the editor is one, a game another. FrameLoop calls these, once
// a frame and in this order.
class Screen {
 public:
  virtual ~Screen() = default;

  // How the panels look in the coming frame.
  virtual GuiLook look() const = 0;
  // Takes in what the user did.
  virtual void hear(const Input& input) = 0;
  // Goes on with what moves or waits: at most for as long as a frame may take.
  virtual void advance() = 0;
  // Draws the picture to the window, and the panels with ImGui.
  virtual void draw() = 0;
  // The panels are drawn over the picture, and nothing of it is on the display yet.
  virtual void drawn() {}
  virtual void took(const FrameTime&) {}

  // Whether the next frame is to begin at once and not at the next event.
  virtual bool moving() const = 0;
  // To be done while nothing moves, before waiting for an event.
  virtual void rest() {}
  // Whether the screen is to be left.
  virtual bool over() const = 0;
};

}  // namespace kerf
