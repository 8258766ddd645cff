#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/game/match/match.h"
#include "ui/game/game_settings.h"
#include "ui/render/view/view_options.h"
#include "ui/window/window.h"

namespace kerf {

// The part of an active enemy that the player's beam would hit first.
struct SightedPart {
  size_t vehicle = 0;  // index of Match::vehicles()
  BodyId body;
  Vec3 at{0};        // m, where the beam would hit it
  std::string name;  // "front left wheel", "engine"
};

// Returns the part in a direction (unit vector) from the player's laser, within its range; nullopt if the
// beam would not hit an enemy first. `sight` must be of the current world of the match.
std::optional<SightedPart> sighted_part(const Match& match, const Sight& sight, const Vec3& aim);

// Returns the end or the first hit of a player's beam along `aim` (unit); m, in the world.
Vec3 place_aimed_at(const Match& match, const Sight& sight, const Vec3& aim);

// Returns true if no wall is between a point and a vehicle.
bool sees_vehicle(const Match& match, const Sight& sight, const Vec3& from, size_t vehicle);

// Converts keyboard, mouse and gamepad input to the controls of the player's vehicle. The mouse aims
// relative to the vehicle: without mouse input the laser turns with it.
class PlayerInput {
 public:
  // Updates the aim and the width of the beam from the events. `settings` scales the motion of the mouse.
  void handle_events(std::span<const InputEvent> events, const GameSettings& settings);
  // Reads held keys, buttons and sticks; a held stick turns the aim for a time [s].
  void poll(const Window& window, double seconds, const GameSettings& settings);
  // Releases all input; mouse motion is then measured from the next reported position.
  void release_all();
  void reset();
  // Turns the aim by these angles [rad], within the limits of the vehicle.
  void turn(double left, double up);

  // Turns the aim slowly, for a time [s], towards an enemy that is close to the aim and not behind a wall.
  // `sight` is of the world of the match.
  void help(const Match& match, const Sight& sight, double seconds);

  // Sets the limits of the vehicle's turret and barrel [rad].
  void limit(const Interval& yaw, const Interval& pitch);

  Controls controls(const Placement& chassis);
  // The player's aim in the world, a unit vector.
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

// Returns true if a view switch is a debug view of the game. The others belong to the graphics preset or to
// the editor.
bool is_debug_view(const ViewSwitch& s);

// Returns the digit whose key toggles a debug view in the game; nullopt if it has none.
std::optional<char> digit_of(SwitchId view);

// Handles the key of a digit: toggles its debug view; 0 turns all of them off. Returns a line for the
// player; empty if the key has no function.
std::string press_digit(char digit, ViewOptions& look);

}  // namespace kerf
