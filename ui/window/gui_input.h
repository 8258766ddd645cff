#pragma once

#include <array>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "ui/window/input_event.h"

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

}  // namespace kerf
