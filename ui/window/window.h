#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec3.h"
#include "ui/window/layout.h"

struct GLFWwindow;

namespace kerf {

// An input event. Positions are in screen coordinates of the window, from its upper left corner.
struct InputEvent {
  enum class Kind { kMove, kPress, kRelease, kWheel, kKey };
  Kind kind = Kind::kMove;
  Vec2 at{0};          // of the pointer
  int button = 0;      // GLFW_MOUSE_BUTTON_*, or the key (GLFW_KEY_*)
  int mods = 0;        // GLFW_MOD_*
  double wheel = 0;    // notches, positive away from the user
  bool again = false;  // a repetition while the key is held
  double seconds = 0;  // when it happened, on a clock that never runs backwards
};

// Spreads the times of events whose order alone is known evenly over an interval (seconds); the last event
// gets its end. Precondition: from <= to.
void spread_times(std::span<InputEvent> events, double from, double to);

// The window with an OpenGL 3.3 context, which is current while the object exists, and its queue of events.
class Window {
 public:
  // Opens a window of a size in screen coordinates. Fails if there is no display or no OpenGL 3.3.
  static Result<Window> open(int width, int height, const std::string& title);

  GLFWwindow* handle() const { return inner_->window; }
  // Whether the user has asked to close the window since the last call. It stays open.
  bool take_close();
  Vec2 size() const;        // screen coordinates
  Vec2 pixel_size() const;  // of the framebuffer
  float scale() const;      // of text, as the display suggests
  void set_title(const std::string& title);
  void swap();

  // Waits for events up to a time in seconds; 0 only polls. GLFW does not tell when an event happened: the
  // times of events that came between two calls are spread evenly over the time between these calls.
  void wait(double seconds);
  // The events since the last call, in the order in which they happened.
  std::vector<InputEvent> take_events();
  // The files that were dropped on the window since the last call.
  std::vector<std::filesystem::path> take_drops();
  // Whether the window received anything since the last call: events, resizing or exposure.
  bool take_activity();

 private:
  struct Inner {
    GLFWwindow* window = nullptr;
    std::vector<InputEvent> events;
    std::vector<std::filesystem::path> drops;
    bool activity = true;
    Vec2 pointer{0};      // where the last event saw it
    double listened = 0;  // s, when the last call of wait() ended
    ~Inner();
  };
  struct Callbacks;
  explicit Window(std::unique_ptr<Inner> inner) : inner_(std::move(inner)) {}
  std::unique_ptr<Inner> inner_;
};

// Converts a rectangle of the window to whole pixels of its framebuffer, from the upper left corner.
Area pixels_of(const Area& area, const Window& window);

}  // namespace kerf
