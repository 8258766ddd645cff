#pragma once

#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/text/json.h"
#include "ui/gl/context.h"
#include "ui/window/window.h"

namespace kerf {

// The mouse, the keyboard and the size of a scripted window.
class VirtualInput {
 public:
  // Input since the last call of a take function.
  struct InputState {
    std::vector<InputEvent> events;
    std::vector<std::filesystem::path> drops;
    bool close = false;
  };

  explicit VirtualInput(Vec2 size) : size_(size) {}

  // Applies a step of the script, an object with one key (see EventScript). Fails and changes nothing if
  // the step is unknown or its value is invalid.
  Status apply(const std::string& name, const JsonValue& value);

  InputState& input_state() { return input_state_; }
  Vec2 size() const { return size_; }
  Vec2 pointer() const { return pointer_; }
  const std::set<int>& keys() const { return keys_; }        // held, GLFW_KEY_*
  const std::set<int>& buttons() const { return buttons_; }  // held, GLFW_MOUSE_BUTTON_*
  int mods() const;                                          // GLFW_MOD_*
  bool has_focus() const { return focus_; }

 private:
  Status move(const JsonValue& value);
  Status hold_button(const JsonValue& value, bool down);
  Status hold_key(const JsonValue& value, bool down);
  Status turn_wheel(const JsonValue& value);
  Status type(const JsonValue& value);
  Status drop(const JsonValue& value);
  Status resize(const JsonValue& value);
  Status focus(const JsonValue& value);
  Status close(const JsonValue& value);
  InputEvent& put(InputEvent::Kind kind, int button = 0);

  InputState input_state_;
  Vec2 size_, pointer_{0};
  std::set<int> keys_, buttons_;
  bool focus_ = true;
};

// Window input from a file (`kerf --events FILE`), which makes sessions bit-reproducible for tests and bug
// reports. Each line is a step, a JSON object with one key. After each step of the first group a frame is
// drawn, or several if one cannot show all of its input (see GuiInput); a fixed time passes between two
// frames.
//
//   {"move": [X, Y]}              the pointer, in pixels from the upper left corner
//   {"press": "left"}             a button of the mouse: left, right or middle
//   {"release": "left"}
//   {"wheel": 1}                  notches, positive away from the user
//   {"key_down": "Ctrl"}          a key: Ctrl, Shift, Alt, Esc, or as menus write it ("Z", "Space", "F8")
//   {"key_up": "Ctrl"}
//   {"type": "text"}              characters, as a keyboard sends them to a text field
//   {"drop": ["FILE", ...]}       files from another program
//   {"size": [WIDTH, HEIGHT]}     of the window
//   {"focus": false}              window focus
//   {"close": true}               the close button of the window
//   {"together": [STEP, ...]}     several of the above before one frame
//   {"wait": SECONDS}             draws frames for this time
//   {"settle": SECONDS}           draws frames until the window is idle, at most for this time
//
//   {"frame": SECONDS}            time between two frames from now on; 1/60 by default
//   {"draws": false}              no frame is drawn from now on; saves time with a software renderer
//   {"picture": "FILE"}           writes the window as a PNG
//   {"answer": "WHAT"}            prints an answer of the screen as a line of JSON: "landmarks" (layout.h),
//                                 "report" or "title"
//
// At the end of the file the program ends as on SIGTERM. An invalid line ends it with an error message.
class EventScript {
 public:
  // The current screen's answer to "landmarks" or "report", as JSON; nullopt if it has none.
  using Answer = std::function<std::optional<std::string>(const std::string& what)>;

  // Reads from a file, or from standard input for "-", as far as needed. Fails if it cannot be opened.
  static Result<EventScript> open(const std::filesystem::path& file, Vec2 size);
  // Reads from a stream; `name` is its name in errors.
  EventScript(std::unique_ptr<std::istream> steps, std::string name, Vec2 size);

  // Advances to the next frame. `moving`: the last frame left work to do. Returns false at the end of the
  // script. Fails at an invalid line. Precondition: `answer` can be called.
  Result<bool> begin_frame(bool moving, const Answer& answer);
  // Advances to another frame of the last step.
  void pass_frame() { seconds_ += frame_seconds_; }

  VirtualInput& input() { return input_; }
  const VirtualInput& input() const { return input_; }
  double frame_seconds() const { return frame_seconds_; }
  // The time at which the frame began [s].
  double seconds() const { return seconds_; }
  bool draws() const { return draws_; }
  void set_title(const std::string& title) { title_ = title; }

 private:
  enum class Next { kStep, kFrame };  // what follows a step

  std::optional<std::string> next_line();
  bool is_still_waiting(bool moving);
  Result<Next> take(const std::string& name, const JsonValue& value, const Answer& answer);
  Result<Next> wait(const JsonValue& value, bool until_rest);
  Status run_simultaneously(const JsonValue& steps);
  Status take_picture(const JsonValue& value) const;
  Status print_answer(const JsonValue& value, const Answer& answer) const;

  std::unique_ptr<std::istream> own_steps_;  // null: standard input
  std::string name_;
  size_t line_ = 0;
  VirtualInput input_;
  std::string title_;
  double frame_seconds_ = 1.0 / 60, seconds_ = 0;
  double wait_until_ = 0;  // s
  bool draws_ = true;
  bool until_rest_ = false;  // the wait ends when nothing moves
  int still_ = 0;            // idle frames of this wait
};

// A window without a screen: a script provides its input (see EventScript), and a surface in memory
// receives its frames.
class ScriptedWindow final : public Window {
 public:
  // Fails if the file cannot be read, or OpenGL 3.3 is not available off-screen.
  static Result<std::unique_ptr<Window>> open(const std::filesystem::path& events, int width, int height);

  Vec2 size() const override { return script_.input().size(); }
  Vec2 pixel_size() const override { return size(); }
  float scale() const override { return 1; }
  void set_title(const std::string& title) override { script_.set_title(title); }
  void swap() override {}
  void wait(double) override {}
  std::vector<InputEvent> take_events() override;
  std::vector<std::filesystem::path> take_drops() override;
  bool take_close() override;
  bool take_activity() override { return true; }
  bool is_key_held(int key) const override { return script_.input().keys().contains(key); }
  bool is_button_held(int button) const override { return script_.input().buttons().contains(button); }
  bool has_focus() const override { return script_.input().has_focus(); }
  void catch_pointer(bool) override {}
  const WindowClock& clock() const override { return clock_; }
  EventScript* script() override { return &script_; }
  bool draws() const override { return script_.draws(); }
  void attach_gui() override;
  void detach_gui() override {}
  void begin_gui_frame() override;

 private:
  // Advances by a fixed time per reading, so that work with a time limit ends after the same number of
  // readings in every run.
  class Clock final : public WindowClock {
   public:
    explicit Clock(const EventScript& script) : script_(script) {}
    double seconds() const override;

   private:
    const EventScript& script_;
    mutable double frame_ = 0;     // s, beginning of the frame of the last reading
    mutable double readings_ = 0;  // in this frame
    mutable double latest_ = 0;    // s, the last reading
  };

  ScriptedWindow(EventScript script, gl::OffscreenContext context);

  EventScript script_;
  gl::OffscreenContext context_;
  Clock clock_;
  Vec2 surface_{0};  // size of the drawing surface
};

}  // namespace kerf
