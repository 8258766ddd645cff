#pragma once

#include <optional>

#include "ui/window/window.h"

namespace kerf {

// A press of a mouse button in the picture that closed a popup. If the pointer then moves, it was the
// beginning of a drag, which must not be lost: a stroke begins where the button was pressed. If the button is
// released without a move, the click has done all that was wanted of it, and nothing is cut or chosen.
class HeldPress {
 public:
  // Keeps the press in place of an earlier one.
  void hold(const InputEvent& press) { held_ = press; }
  // The press whose drag this event begins, once. Any other press and the release of the button drop it.
  std::optional<InputEvent> begun_by(const InputEvent& event);

 private:
  std::optional<InputEvent> held_;
};

}  // namespace kerf
