#pragma once

#include <span>

#include "core/game/match/match.h"
#include "ui/game/game_settings.h"
#include "ui/window/window.h"

namespace kerf {

// Turns keyboard, mouse and gamepad into the controls of the player's vehicle.
//
// The mouse aims relative to the vehicle: without it the laser points where the vehicle goes.
class PlayerInput {
 public:
  // Takes the aim and the width of the beam from the events. `settings` scales the motion of the mouse.
  void hear(std::span<const InputEvent> events, const GameSettings& settings);
  // Looks which keys, buttons and sticks are held, and lets a held stick turn the aim for a time (s).
  void poll(const Window& window, double seconds, const GameSettings& settings);
  // Nothing is held any more, and the next motion of the mouse begins where it is then.
  void let_go();
  // Aims straight ahead.
  void reset();
  // Turns the aim by these angles (rad), within the limits of the vehicle.
  void turn(double left, double up);

  // Turns the aim slowly towards an enemy that is nearly aimed at and behind no wall, for a time (s). `sight`
  // is of the world of the match.
  void help(const Match& match, const Sight& sight, double seconds);

  // The limits of the turret and the barrel of the vehicle that is aimed with (rad), each the lower one
  // first.
  void limit(const Interval& yaw, const Interval& pitch);

  Controls controls(const Placement& chassis);
  // Where the player aims in the world, a unit vector.
  Vec3 direction(const Placement& chassis) const;
  double width() const { return width_; }  // of the beam, 0 .. 1
  // Gives up in the next controls.
  void give_up() { gives_up_ = true; }

 private:
  void take_gamepad(double seconds, const GameSettings& settings);
  double heading(const Placement& chassis) const;

  Interval yaw_limits_{-4, 4}, pitch_limits_{-0.25, 0.6};
  double yaw_ = 0, pitch_ = 0;  // rad, against the heading of the chassis and the horizontal plane
  double width_ = 0.35;
  double throttle_ = 0, steer_ = 0;
  bool handbrake_ = false, fire_ = false, spawn_ = false, gives_up_ = false;
  bool has_pointer_ = false;
  Vec2 pointer_{0};
};

}  // namespace kerf
