#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/game/match/match.h"
#include "ui/game/game_settings.h"
#include "ui/render/view/view_switches.h"
#include "ui/window/window.h"

namespace kerf {

// The part of an enemy that is not out yet, which a beam of the player would meet first.
struct SightedPart {
  size_t vehicle = 0;  // an index of Match::vehicles()
  BodyId body;
  Vec3 at{0};        // m, where the beam would meet it
  std::string name;  // "front left wheel", "engine"
};

// The part in a direction (unit vector) from the player's laser, within its range. `sight` must be of the
// world of the match, as it is. Nothing where the beam would meet no enemy first.
std::optional<SightedPart> sighted_part(const Match& match, const Sight& sight, const Vec3& aim);

// Where a beam of the player along `aim` (unit) would end, or meet something first; m, in the world.
Vec3 place_aimed_at(const Match& match, const Sight& sight, const Vec3& aim);

// Whether no wall stands between a point and a vehicle.
bool sees_vehicle(const Match& match, const Sight& sight, const Vec3& from, size_t vehicle);

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
  void release_all();
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

// Whether a switch of the view is a debug view of the game. The others belong to the preset of the picture,
// or to the editor.
bool is_debug_view(const ViewSwitch& s);

// The digit whose key flips a debug view in the game; nothing if it has none.
std::optional<char> digit_of(SwitchId view);

// What pressing the key of a digit does: flips its debug view, and 0 switches all of them off. Returns a line
// for the player; empty if the key has no meaning.
std::string press_digit(char digit, ViewOptions& look);

}  // namespace kerf
