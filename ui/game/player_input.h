#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/game/match/match.h"
#include "ui/game/game_actions.h"
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

// Returns true if a hub, the laser mount or a vital part of an active enemy is within an angle of the
// player's aim (unit) and no wall is between. `sight` must be of the current world of the match.
bool is_near_part(const Match& match, const Sight& sight, const Vec3& aim);

// The places of hubs, laser mount and vital parts that are attached, in the mesh of a vehicle [m].
std::vector<Vec3> parts_to_cut(const Vehicle& vehicle);

// Steady aim: while it is held, aim and time are slower and the view is narrower, for a few seconds.
class SteadyAim {
 public:
  static constexpr double kSeconds = 2, kRefill = 6;  // s
  static constexpr double kAim = 0.35, kTime = 0.6;   // factors of the speeds
  static constexpr double kView = 42.0 / 62;          // factor of the field of view

  // Advances by a time [s] of the player. Once used up, it waits until the player releases it.
  void advance(bool held, double seconds);
  void reset() { *this = SteadyAim(); }
  bool is_on() const { return on_; }
  double left() const { return left_; }  // 0 .. 1
  // The factors now, between 1 and those above.
  double aim_factor() const { return 1 + share_ * (kAim - 1); }
  double time_factor() const { return 1 + share_ * (kTime - 1); }
  double view_factor() const { return 1 + share_ * (kView - 1); }

 private:
  bool on_ = false, spent_ = false;
  double left_ = 1, share_ = 0;  // share_ eases from 0 to 1 while it is on
};

// Converts keyboard, mouse and gamepad input to the controls of the player's vehicle. The mouse aims
// relative to the vehicle: without mouse input the laser turns with it.
class PlayerInput {
 public:
  // Updates held actions, the aim and the width of the beam from the events. `settings` scales the motion of
  // the mouse.
  void handle_events(std::span<const InputEvent> events, const GameSettings& settings);
  // Applies the state of a gamepad for a time [s]: a held stick turns the aim. `friction` slows that down
  // (see is_near_part).
  void apply_gamepad(const GamepadState& pad, double seconds, const GameSettings& settings, bool friction);
  static constexpr double kFriction = 0.55;  // of the speed

  // Releases all input; mouse motion is then measured from the next reported position.
  void release_all();
  // Sets which actions are held from the keys and mouse buttons that `window` reports, without counting a
  // press.
  void take_held_controls(const Window& window, const KeyBindings& bindings);
  void reset();
  // Turns the aim by these angles [rad], within the limits of the vehicle.
  void turn(double left, double up);

  // Turns the aim slowly, for a time [s], towards an enemy that is close to the aim and not behind a wall.
  // No-op while the player fires, for kAimRest after a motion of the aim, and on a gamepad. `sight` is of
  // the world of the match.
  void help(const Match& match, const Sight& sight, double seconds);
  static constexpr double kAimRest = 0.15;  // s

  // Sets the limits of the vehicle's turret and barrel [rad].
  void limit(const Interval& yaw, const Interval& pitch);

  // Selects an upgrade (see Controls) in the next controls.
  void select_upgrade(uint8_t upgrade) { upgrade_ = upgrade; }

  // Returns the controls for the next tick. A press between two ticks acts for one tick at least.
  Controls controls(const Placement& chassis);
  // The player's aim in the world, a unit vector.
  Vec3 direction(const Placement& chassis) const;
  double width() const { return width_; }  // of the beam, 0 .. 1
  bool is_steady_held() const { return latches_[static_cast<size_t>(GameAction::kSteady)].is_held(); }

 private:
  ActionLatch& latch(GameAction action) { return latches_[static_cast<size_t>(action)]; }
  void handle_motion(const InputEvent& event, const GameSettings& settings);
  double heading(const Placement& chassis) const;

  Interval yaw_limits_{-4, 4}, pitch_limits_{-0.25, 0.6};
  double yaw_ = 0, pitch_ = 0;  // rad, against the heading of the chassis and the horizontal plane
  double width_ = 0.35;
  uint8_t upgrade_ = 0;
  std::array<ActionLatch, kGameActions> latches_;
  GamepadState pad_;                 // at its last state
  double throttle_ = 0, steer_ = 0;  // of the stick
  double still_s_ = 0;               // time since the last motion of the aim
  bool on_pad_ = false;              // the last motion was that of a stick
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
