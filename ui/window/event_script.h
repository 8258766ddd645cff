#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "ui/window/virtual_input.h"

namespace kerf {

// Input of a window from a file (`kerf --events FILE`), so that a session repeats to the bit: tests and
// reports of faults are written in it. Each line is a step, a JSON object with one key. After each of the
// first group a frame is drawn, or several where one cannot show all of its input (see gui_input.h); between
// two frames a fixed time passes.
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
//   {"focus": false}              whether the window has it
//   {"close": true}               the button that closes the window
//   {"together": [STEP, ...]}     several of the above before one frame
//   {"wait": SECONDS}             frames for so long
//   {"settle": SECONDS}           frames until nothing moves or works, for so long at most
//
//   {"frame": SECONDS}            between two frames from now on; a sixtieth before
//   {"draws": false}              whether frames are drawn from now on, which takes a software renderer
//   nearly
//                                 all of their time; all else happens as ever
//   {"picture": "FILE"}           writes what the window shows as a PNG
//   {"answer": "WHAT"}            prints what the screen knows as a line of JSON: "landmarks" (landmarks.h),
//                                 "report" or "title"
//
// At the end of the file the program ends as by SIGTERM. A line that is wrong ends it with a sentence.
class EventScript {
 public:
  // What the screen that is shown answers to "landmarks" or "report", as JSON; nothing where it has no
  // answer.
  using Answer = std::function<std::optional<std::string>(const std::string& what)>;

  // Reads from a file, or from standard input where it is "-", as far as it is needed. Fails if it cannot be
  // opened.
  static Result<EventScript> open(const std::filesystem::path& file, Vec2 size);
  // Reads from a text that is called `name` in errors.
  EventScript(std::unique_ptr<std::istream> steps, std::string name, Vec2 size);

  // Goes on to the next frame. `moving`: whether the last one left something to do. Returns whether there is
  // one; at the end of the script there is none. Fails at a line that is wrong. Precondition: `answer` can be
  // called.
  Result<bool> begin_frame(bool moving, const Answer& answer);
  // Goes on to another frame of the step that was taken last.
  void pass_frame() { seconds_ += frame_seconds_; }

  VirtualInput& input() { return input_; }
  const VirtualInput& input() const { return input_; }
  double frame_seconds() const { return frame_seconds_; }
  // The time at which the frame began (s).
  double seconds() const { return seconds_; }
  bool draws() const { return draws_; }
  void set_title(const std::string& title) { title_ = title; }

 private:
  enum class Next { kStep, kFrame };  // what follows a step

  std::optional<std::string> next_line();
  bool goes_on_waiting(bool moving);
  Result<Next> take(const std::string& name, const JsonValue& value, const Answer& answer);
  Result<Next> wait(const JsonValue& value, bool until_rest);
  Status hear_together(const JsonValue& steps);
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
  bool until_rest_ = false;  // the wait ends where nothing moves
  int still_ = 0;            // frames of this wait
};

}  // namespace kerf
