#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec3.h"

struct GLFWwindow;

namespace kerf {

// What the user did, in the order in which it happened. Positions are in screen coordinates of the window,
// from its upper left corner.
struct InputEvent {
  enum class Kind { kMove, kPress, kRelease, kWheel, kKey };
  Kind kind = Kind::kMove;
  Vec2 at{0};          // of the pointer
  int button = 0;      // GLFW_MOUSE_BUTTON_*, or the key (GLFW_KEY_*)
  int mods = 0;        // GLFW_MOD_*
  double wheel = 0;    // notches away from the user
  bool again = false;  // a key that is held down
};

// The window with its OpenGL 3.3 context, current while it lives, and the queue of what happened in it.
class Window {
 public:
  static Result<Window> open(int width, int height, const std::string& title);

  GLFWwindow* handle() const { return inner_->window; }
  // Whether the user asked for it to close since the last call; it stays open.
  bool take_close();
  Vec2 size() const;        // screen coordinates
  Vec2 pixel_size() const;  // of the framebuffer
  float scale() const;      // of text, as the display asks for it
  void set_title(const std::string& title);
  void swap();

  // Waits up to so many seconds for something to happen; 0 only looks.
  void wait(double seconds);
  // What happened since the last call.
  std::vector<InputEvent> take_events();
  // Files that were dropped on it since the last call.
  std::vector<std::filesystem::path> take_drops();
  // Whether anything at all happened since the last call: events, resizing, uncovering.
  bool take_activity();

 private:
  struct Inner {
    GLFWwindow* window = nullptr;
    std::vector<InputEvent> events;
    std::vector<std::filesystem::path> drops;
    bool activity = true;
    ~Inner();
  };
  struct Callbacks;
  explicit Window(std::unique_ptr<Inner> inner) : inner_(std::move(inner)) {}
  std::unique_ptr<Inner> inner_;
};

}  // namespace kerf
