#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/game/arena/free_space.h"
#include "core/game/arena/sight.h"
#include "core/game/driver/pilot.h"
#include "core/game/match/match_world.h"
#include "core/game/match/rules.h"
#include "core/game/match/tally.h"
#include "core/game/vehicle/laser_gun.h"

namespace kerf {

struct MatchSetup {
  std::shared_ptr<const Rules> rules;  // not null
  uint64_t seed = 1;
  Difficulty difficulty = Difficulty::kNormal;
};

// How a match stands where a wave begins: all that a wave depends on besides the setup of the match.
struct WaveStart {
  Standing standing;
  Placement player;         // of the player's vehicle
  size_t strokes = 0;       // of the player before
  std::vector<size_t> out;  // enemies of the wave that an earlier car of the player put out of action
};

// A match: the player's vehicle against waves of enemies in an arena.
//
// A tick turns the controls of all drivers into forces and beams, moves the bodies, cuts, makes what came off
// bodies of their own, and reads from the meshes what the vehicles have lost. The result
// is a function of the setup and of the player's controls: the same ones give the same world, to the bit, on
// one kind of machine. A wave begins with a world that is made anew, so that memory does not grow: the
// player's vehicle is whole again where it was, and wrecks and pieces are gone.
class Match {
 public:
  explicit Match(MatchSetup setup);
  // Goes on where a wave of a match with the same setup began. Precondition: the wave exists.
  Match(MatchSetup setup, const WaveStart& start);

  // Advances by 1/120 s. Once it is over, the world goes on for kAftermath ticks, in which nobody drives,
  // fires or scores, so that what is in the air comes down; after that nothing happens any more.
  void tick(const Controls& player);
  static constexpr Ticks kAftermath = 3 * kTicksPerSecond;
  // Whether the match is over, and its world has come to its end.
  bool settled() const { return standing().over() && standing().aftermath == kAftermath; }

  // Whether the player drives a car without a laser. Who gives up then has lost that car.
  bool is_disabled() const;

  const Rules& rules() const { return *setup_.rules; }
  const MatchSetup& setup() const { return setup_; }
  const Standing& standing() const { return tally_.standing(); }
  // Where the present wave began.
  const WaveStart& wave_start() const { return wave_start_; }
  // The seconds that are left to win.
  double seconds_left() const;
  // How often the player switched the beam on.
  size_t strokes() const { return tally_.strokes(); }

  const World& world() const { return world_.world(); }
  const Physics& physics() const { return world_.physics(); }
  // The vehicles of the wave, the player's first, then its enemies, then those that were asked for.
  static constexpr size_t kPlayer = Tally::kPlayer;
  const std::vector<Vehicle>& vehicles() const { return vehicles_; }
  // The index of the vehicle that a body is or is carried by, or Event::kNobody.
  size_t vehicle_of(BodyId body) const;
  // Whether a body stops a beam.
  bool is_wall(BodyId body) const;

  // What the last tick changed in the world, and what happened in it.
  const Delta& delta() const { return world_.delta(); }
  const std::vector<Event>& events() const { return tally_.events(); }

  // What the driver of a vehicle sees. `sight` must be of world(), as it is.
  DriverView view(size_t vehicle, const Sight& sight) const;

 private:
  void begin_wave(const WaveStart& start);
  void add_enemies(const WaveStart& start, Delta& came);
  void spawn();
  void steer_vehicles(const Sight& sight);
  void go_on_afterwards();
  void take_controls(const Controls& player, const Sight& sight);
  void take_turns();
  std::vector<Guided> guided() const;
  std::vector<BodyId> carried() const;
  std::vector<Vec3> velocities() const;
  void move_bodies(PlacementsBefore& before);
  void record_impacts(const std::vector<Vec3>& velocities);
  void crash(size_t vehicle, const Vec3& at, const Vec3& change);
  void fire_beams(const PlacementsBefore& before);
  void separate();
  void assess();
  void recover();
  void judge();
  Ticks pause() const;
  void lose_car();
  void end_pause();

  MatchSetup setup_;
  Obstacles obstacles_;
  FreeSpace space_;
  Tally tally_;
  WaveStart wave_start_;
  MatchWorld world_;
  std::vector<Vehicle> vehicles_;
  std::vector<Disc> traffic_;    // as it was when drivers last looked around
  std::vector<Pilot> pilots_;    // of the enemies
  std::vector<size_t> enemies_;  // indices of vehicles that fight
  std::vector<size_t> numbers_;  // of these in the wave of the rules
  bool asked_ = false;           // for a vehicle, in the last tick
  std::vector<Vec3> thrown_;     // by vehicle, m/s, what comes off it in this tick by a crash
};

// Plays the player's side of a match: one vehicle after the other, with a quick eye and a steady hand.
class BotPlayer {
 public:
  explicit BotPlayer(const Match& match);

  // The controls for the next tick. To be called once a tick.
  Controls next(const Match& match);

 private:
  Pilot pilot_;
};

}  // namespace kerf
