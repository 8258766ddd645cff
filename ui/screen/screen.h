#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/window/gui.h"
#include "ui/window/gui_look.h"
#include "ui/window/window.h"

namespace kerf {

// What the user did in the window since the last frame.
struct Input {
  std::vector<InputEvent> events;
  std::vector<std::filesystem::path> drops;  // files that were dropped on the window
  bool close = false;                        // the user asked to close the window
};

// The duration of a frame in seconds.
struct FrameTime {
  double whole = 0;   // of the frame, without waiting for it to begin
  double before = 0;  // from its beginning until it was handed to the display
};

// What the window shows: the editor is a screen, and a game is another. FrameLoop calls these functions once
// per frame in this order.
class Screen {
 public:
  virtual ~Screen() = default;

  // Whether keys and characters wait, and do not reach the next frame.
  virtual KeyboardHold keyboard_hold() const { return KeyboardHold::kNone; }
  // The look of the panels in the next frame.
  virtual GuiLook look() const = 0;
  // Processes user input.
  virtual void hear(const Input& input) = 0;
  // Advances everything that moves or waits, for at most the duration of a frame.
  virtual void advance() = 0;
  // Draws the picture to the window, and the panels with ImGui.
  virtual void draw() = 0;
  // Called when the picture and the panels are drawn but not displayed yet.
  virtual void drawn() {}
  virtual void took(const FrameTime&) {}

  // Whether the next frame starts at once rather than at the next event.
  virtual bool moving() const = 0;
  // How long a frame stays at least (s) where no input comes: where nothing moves but the progress of work in
  // the background, which needs the processors more than pictures of it do.
  virtual double least_frame() const { return 0; }
  // Called before waiting for an event while nothing moves.
  virtual void rest() {}
  // Whether the screen is to be left.
  virtual bool over() const = 0;

  // What the screen tells the script that drives the window, as JSON; nothing where it knows no such word
  // (see EventScript::Answer).
  virtual std::optional<std::string> answer(const std::string&) const { return std::nullopt; }
};

}  // namespace kerf
