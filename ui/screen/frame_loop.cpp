#include "ui/screen/frame_loop.h"

#include <algorithm>
#include <thread>

namespace kerf {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrameSeconds = 1.0 / 60;  // minimum interval between the beginnings of frames
// after the last event; panels are still drawn, so that tooltips can appear
constexpr double kSettleSeconds = 1.0;
constexpr double kSettleWait = 0.12, kIdleWait = 0.5;

double seconds_since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

}  // namespace

bool FrameLoop::run(Screen& screen) {
  while (!screen.over() && wait(screen)) frame(screen);
  return screen.over();
}

// Returns immediately while something moves, at an event otherwise; false if there is no next frame.
bool FrameLoop::wait(Screen& screen) {
  if (stop_.received()) return false;
  if (EventScript* script = window_.script()) return follow(*script, screen);
  const double left = kFrameSeconds - seconds_since(frame_began_);
  if (left > 0) std::this_thread::sleep_for(std::chrono::duration<double>(left));
  window_.wait(std::max(0.0, screen.min_frame_seconds() - seconds_since(frame_began_)));
  while (!screen.moving() && !gui_.input_waits() && !window_.take_activity() && !stop_.received()) {
    screen.rest();
    const bool settling = seconds_since(last_event_) < kSettleSeconds;
    window_.wait(settling ? kSettleWait : kIdleWait);
    if (settling) {
      frame_began_ = Clock::now();
      return true;
    }
  }
  last_event_ = Clock::now();
  frame_began_ = Clock::now();
  return !stop_.received();
}

bool FrameLoop::follow(EventScript& script, Screen& screen) {
  if (gui_.input_waits()) {  // more frames of the last step
    script.pass_frame();
    return true;
  }
  const bool moving = screen.moving();
  if (!moving) screen.rest();
  const auto next = script.begin_frame(moving, [&](const std::string& what) { return screen.answer(what); });
  if (!next) fault_ = next.error().message;
  return next && *next;
}

void FrameLoop::frame(Screen& screen) {
  const Clock::time_point began = Clock::now();
  gui_.dress(screen.look());
  screen.handle_input(take_input(screen));
  screen.advance();
  screen.draw();
  gui_.end_frame();
  screen.drawn();
  const double before = seconds_since(began);
  window_.swap();
  if (const EventScript* script = window_.script()) {
    screen.took({script->frame_seconds(), script->frame_seconds()});
  } else {
    screen.took({seconds_since(began), before});
  }
}

// Also begins the frame of the panels.
Input FrameLoop::take_input(const Screen& screen) {
  Input input;
  input.events = gui_.begin_frame(screen.keyboard_hold());
  input.drops = window_.take_drops();
  input.close = window_.take_close();
  return input;
}

}  // namespace kerf
