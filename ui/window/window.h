#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/window/input_event.h"
#include "ui/window/layout.h"
#include "ui/window/window_clock.h"

namespace kerf {

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

}  // namespace kerf
