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
#include "ui/gl/image.h"
#include "ui/window/layout.h"

namespace kerf {

// An input event. Positions are in screen coordinates of the window, from its upper left corner.
struct InputEvent {
  enum class Kind { kMove, kPress, kRelease, kWheel, kKey, kKeyUp, kText };
  Kind kind = Kind::kMove;
  Vec2 at{0};              // of the pointer
  int button = 0;          // GLFW_MOUSE_BUTTON_*, or the key (GLFW_KEY_*) of the character on it
  int mods = 0;            // GLFW_MOD_*
  double wheel = 0;        // notches, positive away from the user
  bool again = false;      // a repetition of a held key
  double wheel_aside = 0;  // notches, positive to the right
  unsigned character = 0;  // of kText, a code point
  double seconds = 0;      // time of the event by the clock of the window
  int place = 0;           // of a key: its place on a US keyboard (GLFW_KEY_*), for the controls of the game
};

// Spreads the times of events evenly over an interval [s] if only their order is known; the last event gets
// its end. Precondition: from <= to.
void spread_times(std::span<InputEvent> events, double from, double to);

struct KeyChord {
  int key = 0;   // GLFW_KEY_*; 0: none
  int mods = 0;  // GLFW_MOD_CONTROL, SHIFT, ALT
  friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

// The chord as menus and settings write it: "Ctrl+Shift+Z", "Del", "F4"; empty for a key without a name.
std::string chord_text(const KeyChord& chord);

// The inverse of chord_text(); nullopt if the text names no chord.
std::optional<KeyChord> parse_chord(std::string_view text);

// Returns the key (GLFW_KEY_*) of the character on a key, so that shortcuts follow the layout of the
// keyboard. `place` is the place of the key on a US keyboard (GLFW_KEY_*), `name` its name by GLFW or null.
// Keys of the digit row, and keys with characters that have no GLFW_KEY_*, keep their place.
int character_key(int place, const char* name);

// The same in the current layout of the keyboard. Returns `place` if GLFW is not initialised.
int character_key(int place);

// Returns true if the key (GLFW_KEY_*) is Shift, Ctrl, Alt or Super.
bool is_modifier(int key);

// A monotonic clock in seconds. Screens time work with the clock of their window, which makes runs of a
// scripted window reproducible.
class WindowClock {
 public:
  virtual ~WindowClock() = default;
  virtual double seconds() const = 0;
};

class EventScript;

// A window with an OpenGL 3.3 context, current while the object exists, and its queue of events: on the
// desktop (DesktopWindow), or scripted without a screen (ScriptedWindow).
class Window {
 public:
  Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  virtual ~Window() = default;

  virtual Vec2 size() const = 0;        // screen coordinates
  virtual Vec2 pixel_size() const = 0;  // of the framebuffer
  virtual float scale() const = 0;      // of text in screen coordinates, as suggested by the display
  virtual void set_title(const std::string& title) = 0;
  virtual void swap() = 0;

  // Waits for events up to a time in seconds; 0 only polls.
  virtual void wait(double seconds) = 0;
  // Returns the events since the last call, in order.
  virtual std::vector<InputEvent> take_events() = 0;
  virtual std::vector<std::filesystem::path> take_drops() = 0;
  // Returns true if the user has requested to close the window since the last call. It stays open.
  virtual bool take_close() = 0;
  // Returns true if the window received anything since the last call: events, resizing or exposure.
  virtual bool take_activity() = 0;

  virtual bool is_key_held(int key) const = 0;        // GLFW_KEY_*, by place
  virtual bool is_button_held(int button) const = 0;  // GLFW_MOUSE_BUTTON_*
  virtual bool has_focus() const = 0;
  // Hides and captures the pointer, for unlimited movement, or releases it.
  virtual void catch_pointer(bool caught) = 0;

  virtual const WindowClock& clock() const = 0;
  // The script that drives the window, or null. A script decides when a frame begins, and all background
  // work finishes between two frames.
  virtual EventScript* script() { return nullptr; }
  // Returns true if the frame is visible to anyone and must be drawn.
  virtual bool draws() const { return true; }

  // Connect the current ImGui context with the window, and disconnect it.
  virtual void attach_gui() = 0;
  virtual void detach_gui() = 0;
  // Passes the size of the window, the time since the last frame and the pointer to ImGui. All other input
  // comes from the events (see GuiInput).
  virtual void begin_gui_frame() = 0;
};

// Converts a rectangle of the window to whole pixels of its framebuffer, from the upper left corner.
Area pixels_of(const Area& area, const Window& window);

struct WindowOptions {
  int width = 0, height = 0;                    // screen coordinates; 0: 1280x800 at the scale of the display
  std::optional<std::filesystem::path> events;  // the script of a window without a screen (see EventScript)
};

// Opens a desktop window, or a scripted one, whose scale is 1. Fails if there is no display or no OpenGL 3.3,
// or if the script cannot be read.
Result<std::unique_ptr<Window>> open_window(const WindowOptions& options);

// Returns a part of the window (in pixels of the framebuffer, from its upper left corner) as drawn so far.
Pixels window_pixels(Vec2 window, const Area& part);

// Writes a part of the window to a PNG file named by date and time, in the current folder or, if that is
// not writable, in ~/Pictures. Returns its path.
Result<std::filesystem::path> take_screenshot(Vec2 window, const Area& part);

}  // namespace kerf
