#pragma once

#include <span>

#include "core/base/vec3.h"

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

}  // namespace kerf
