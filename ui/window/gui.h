#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "ui/gl/framebuffer.h"
#include "ui/window/gui_look.h"
#include "ui/window/theme.h"
#include "ui/window/window.h"

struct ImGuiIO;

namespace kerf {

// Why keys and characters wait in the queue.
enum class KeyboardHold {
  kNone,
  kForFocus,  // a text field or a dialog opens, and does not have the keyboard yet
  kForWork,   // nothing can be done at the moment; Esc and the mouse stop the work
};

// Whether a text field of ImGui has the keyboard, so that keys are no shortcuts. Precondition: an ImGui
// context is current.
bool is_text_field_active();

// The queue of input events between a window and ImGui 1.86, which sees the state of keys and buttons once a
// frame and would miss what changes twice within one. A frame gets as many events as it can show in their
// order: it ends before the second change of a key or the second press of a button, before a second key that
// is a command (all but those that type), and before a character that follows such a key. So a key that opens
// something ends the frame, and what follows meets what was opened.
class GuiInput {
 public:
  void add(std::span<const InputEvent> events);
  bool waits() const { return !queue_.empty(); }

  // Removes and returns the events of the next frame. `typing`: a text field has the keyboard. A hold for the
  // focus lasts a few frames in a row at most, because nothing may come of what was asked for.
  std::vector<InputEvent> take_frame(bool typing, KeyboardHold hold);
  // Sets the keys, the characters, the mouse and its buttons that ImGui sees in the next frame. To be called
  // once a frame with the events that take_frame() returned, when the window has set the pointer.
  void feed(std::span<const InputEvent> events, ImGuiIO& io);

 private:
  static constexpr size_t kButtons = 5;

  bool shows_pressed(int button) const;
  std::vector<InputEvent> take_while_working();

  std::deque<InputEvent> queue_;
  std::array<bool, kButtons> down_{};   // buttons of the mouse
  std::array<bool, kButtons> shown_{};  // as ImGui saw them in the last frame
  std::optional<Vec2> pointer_;         // at the last event that was fed
  int held_frames_ = 0;                 // in a row, for the focus
};

// ImGui::NewFrame(), without the repetitions of held keys that ImGui counts by frames: a key is pressed again
// where the events say so.
void begin_gui_frame_with_keys(std::span<const InputEvent> events);

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

// Runs ImGui without a window, to draw text and lines on pictures. An OpenGL context must be current while it
// exists, and no other ImGui context may be.
class OffscreenGui {
 public:
  explicit OffscreenGui(const GuiLook& look);
  ~OffscreenGui();
  OffscreenGui(const OffscreenGui&) = delete;
  OffscreenGui& operator=(const OffscreenGui&) = delete;

  // Draws over a picture what `paint` adds to ImGui's background list, in pixels from the upper left corner.
  // Precondition: it does not call this itself.
  void draw(const gl::Framebuffer& over, const std::function<void()>& paint);
};

}  // namespace kerf
