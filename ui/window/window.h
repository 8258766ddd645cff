#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "ui/render/png.h"
#include "ui/window/layout.h"

namespace kerf {

// An input event. Positions are in screen coordinates of the window, from its upper left corner.
struct InputEvent {
  enum class Kind { kMove, kPress, kRelease, kWheel, kKey, kKeyUp, kText };
  Kind kind = Kind::kMove;
  Vec2 at{0};              // of the pointer
  int button = 0;          // GLFW_MOUSE_BUTTON_*, or the key (GLFW_KEY_*)
  int mods = 0;            // GLFW_MOD_*
  double wheel = 0;        // notches, positive away from the user
  bool again = false;      // a repetition while the key is held
  double wheel_aside = 0;  // notches, positive to the right
  unsigned character = 0;  // of kText, a code point
  double seconds = 0;      // when it happened, by the clock of the window
};

// Spreads the times of events whose order alone is known evenly over an interval (seconds); the last event
// gets its end. Precondition: from <= to.
void spread_times(std::span<InputEvent> events, double from, double to);

// A key with modifiers.
struct KeyChord {
  int key = 0;   // GLFW_KEY_*; 0: none
  int mods = 0;  // GLFW_MOD_CONTROL, SHIFT, ALT
  friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

// The chord as menus and settings write it: "Ctrl+Shift+Z", "Del", "F4"; empty for a key without a name.
std::string chord_text(const KeyChord& chord);

// The chord of such a text; nothing where it names none. The inverse of chord_text().
std::optional<KeyChord> parse_chord(std::string_view text);

// Whether the key (GLFW_KEY_*) is Shift, Ctrl, Alt or Super.
bool is_modifier(int key);

// A clock in seconds that never runs backwards. What a screen does for a part of a frame, or once in a while,
// is timed by the clock of its window, so that a window that a script drives shows the same in every run.
class WindowClock {
 public:
  virtual ~WindowClock() = default;
  virtual double seconds() const = 0;
};

class EventScript;

// A window with an OpenGL 3.3 context, which is current while the object exists, and its queue of events: one
// on the desktop (DesktopWindow), or one without a screen that a script drives (ScriptedWindow).
class Window {
 public:
  Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  virtual ~Window() = default;

  virtual Vec2 size() const = 0;        // screen coordinates
  virtual Vec2 pixel_size() const = 0;  // of the framebuffer
  virtual float scale() const = 0;      // of text, as the display suggests
  virtual void set_title(const std::string& title) = 0;
  // Shows what was drawn.
  virtual void swap() = 0;

  // Waits for events up to a time in seconds; 0 only polls.
  virtual void wait(double seconds) = 0;
  // The events since the last call, in the order in which they happened.
  virtual std::vector<InputEvent> take_events() = 0;
  // The files that were dropped on the window since the last call.
  virtual std::vector<std::filesystem::path> take_drops() = 0;
  // Whether the user has asked to close the window since the last call. It stays open.
  virtual bool take_close() = 0;
  // Whether the window received anything since the last call: events, resizing or exposure.
  virtual bool take_activity() = 0;

  virtual bool is_key_held(int key) const = 0;        // GLFW_KEY_*
  virtual bool is_button_held(int button) const = 0;  // GLFW_MOUSE_BUTTON_*
  virtual bool has_focus() const = 0;
  // Hides the pointer and lets it move without end, or gives it back.
  virtual void catch_pointer(bool caught) = 0;

  virtual const WindowClock& clock() const = 0;
  // What drives the window instead of a user, or null. A script decides when a frame begins, and whatever
  // works in the background is waited for between two frames.
  virtual EventScript* script() { return nullptr; }
  // Whether what is drawn in this frame is seen by anyone.
  virtual bool draws() const { return true; }

  // Connects the current ImGui context with the window, and ends that.
  virtual void attach_gui() = 0;
  virtual void detach_gui() = 0;
  // Tells ImGui the size of the window, the time since the last frame and where the pointer is. All other
  // input comes from the events (see gui_input.h).
  virtual void begin_gui_frame() = 0;
};

// Converts a rectangle of the window to whole pixels of its framebuffer, from the upper left corner.
Area pixels_of(const Area& area, const Window& window);

// The window that a program asks for.
struct WindowOptions {
  int width = 0, height = 0;  // screen coordinates
  std::optional<std::filesystem::path>
      events;  // a script that drives it without a screen (see event_script.h)
};

// Opens a window on the desktop, or one that a script drives. Fails if there is no display or no OpenGL 3.3,
// or if the script cannot be read.
Result<std::unique_ptr<Window>> open_window(const WindowOptions& options);

// A part of the window (in pixels of the framebuffer, from its upper left corner) as it is drawn so far.
Pixels window_pixels(Vec2 window, const Area& part);

// Writes a part of the window to a PNG file that is named by date and time, in the current folder or, if that
// is not writable, in ~/Pictures. Returns the path of the file.
Result<std::filesystem::path> take_screenshot(Vec2 window, const Area& part);

}  // namespace kerf
