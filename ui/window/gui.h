#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "ui/gl/buffers.h"
#include "ui/window/gui_look.h"
#include "ui/window/window.h"

struct ImGuiIO;

namespace kerf {

// Why keys and characters are held back in the queue.
enum class KeyboardHold {
  kNone,
  kForFocus,  // a text field or a dialog opens, and does not have the keyboard focus yet
  kForWork,   // uninterruptible work runs; only Esc and the mouse, which stop it, pass
};

// Returns true if a text field of ImGui has the keyboard focus, so that keys are no shortcuts.
// Precondition: an ImGui context is current.
bool is_text_field_active();
// Returns true if no text field has the keyboard focus and no popup is open, so that keys act on the
// viewport. Same precondition.
bool are_keys_free();

// The queue of input events between a window and ImGui 1.86, which samples the state of keys and buttons
// once per frame and would miss two changes within one. A frame gets as many events as it can show in their
// order: it ends before the second change of a key or the second press of a button, before a second command
// key (any key that types no character), and before a character that follows such a key. So a key that
// opens a dialog ends the frame, and the following input reaches the dialog.
class GuiInput {
 public:
  void add(std::span<const InputEvent> events);
  bool waits() const { return !queue_.empty(); }

  // Removes and returns the events of the next frame. `typing`: a text field has the keyboard focus. A hold
  // for the focus lasts only a few consecutive frames, because the requested dialog may never open.
  std::vector<InputEvent> take_frame(bool typing, KeyboardHold hold);
  // Sets the keys, characters, pointer and mouse buttons for ImGui's next frame. Must be called once per
  // frame with the events from take_frame(), after the window has set the pointer.
  void feed(std::span<const InputEvent> events, ImGuiIO& io);

 private:
  static constexpr size_t kButtons = 5;

  bool shows_pressed(int button) const;
  std::vector<InputEvent> take_while_working();

  std::deque<InputEvent> queue_;
  std::array<bool, kButtons> down_{};   // mouse buttons
  std::array<bool, kButtons> shown_{};  // as ImGui saw them in the last frame
  std::optional<Vec2> pointer_;         // at the last fed event
  int held_frames_ = 0;                 // consecutive frames held for the focus
};

// ImGui::NewFrame() without ImGui's own key repetition, which counts frames: only repeated events repeat a
// key.
void begin_gui_frame_with_keys(std::span<const InputEvent> events);

// Keeps ImGui's active slider or button in a frame that omits the panels; ImGui deactivates an item that a
// frame does not draw. Must be called within each such frame.
void keep_active_item();

// Runs ImGui in a window: its context, fonts, colours and frames.
class Gui {
 public:
  // The window must outlive it. Precondition: there is no other ImGui context.
  explicit Gui(Window& window);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  // Changes the look; no-op if unchanged. Precondition: called between frames.
  void dress(const GuiLook& look);

  // Begins a frame and returns its events: as many of those received as one frame can show in their order
  // (see GuiInput). Each frame must end before the next one begins.
  std::vector<InputEvent> begin_frame(KeyboardHold hold);
  bool input_waits() const { return input_.waits(); }
  void end_frame();

 private:
  void hold_release(std::span<const InputEvent> events);

  Window& window_;
  GuiInput input_;
  std::optional<GuiLook> look_;
  std::optional<Vec2> released_;  // position of the left button's release while its item was hidden
  float last_frame_seconds_ = 0;
};

// Runs ImGui without a window, to draw text and lines on images. While it exists, an OpenGL context must be
// current, and there must be no other ImGui context.
class OffscreenGui {
 public:
  explicit OffscreenGui(const GuiLook& look);
  ~OffscreenGui();
  OffscreenGui(const OffscreenGui&) = delete;
  OffscreenGui& operator=(const OffscreenGui&) = delete;

  // Draws everything that `paint` adds to ImGui's background list over an image, in pixels from the upper
  // left corner. Precondition: `paint` does not call draw().
  void draw(const gl::Framebuffer& over, const std::function<void()>& paint);
};

}  // namespace kerf
