#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/game/arena/arena.h"
#include "core/game/driver/pilot.h"
#include "core/game/driver/steering.h"
#include "core/game/match/cut_motion.h"
#include "core/game/match/match_world.h"
#include "core/game/match/rules.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// Sorts the enemy starts of an arena for a player at a place [m]: first those with a route of about 30 m to
// it, so that enemies arrive soon and can be seen arriving. O(starts * spots log spots) in the worst case.
std::vector<Start> starts_by_way(const ArenaDescription& arena, const FreeSpace& space, const Vec3& player);

// A place for another vehicle, across the view from a vehicle and at most 13 m away, ahead of it if there
// is room, else at its side or behind it; nullopt if there is none.
std::optional<Placement> place_before(const Placement& vehicle, const FreeSpace& space,
                                      std::span<const Disc> traffic);

// Measures how long a vehicle lies on its side or roof, and how long it makes no progress although it tries
// to or lies there, and recovers it after a while if it is alive and has a wheel. A lying vehicle is put
// upright in place, a little higher. A stuck one, or one that makes no progress after that, is moved to
// where it last drove freely, or else to the nearest place in `space` with room; a wedged one (see
// backed_off) is moved there immediately. Returns true if it recovered the vehicle. Call once per tick.
bool recover_vehicle(World& world, Vehicle& vehicle, const FreeSpace& space, const MatchTimes& times);

// A placement with the heading of another one, upright and a little above it, not below the ground [m].
Placement upright(const Placement& placement, double ground);

struct MatchSetup {
  std::shared_ptr<const Rules> rules;  // not null
  uint64_t seed = 1;
  Difficulty difficulty = Difficulty::kNormal;
};

// The state of a match at the start of a wave: everything a wave depends on except the setup of the match.
struct WaveStart {
  Standing standing;
  Placement player;         // of the player's vehicle
  size_t strokes = 0;       // number of earlier strokes of the player
  std::vector<size_t> out;  // enemies of the wave disabled by an earlier car of the player
};

// A match: the player's vehicle against waves of enemies in an arena.
//
// A tick turns the controls of all drivers into forces and beams, moves the bodies, cuts, makes separated
// pieces bodies of their own, and reads the damage of the vehicles from the meshes. The result is a
// function of the setup and of the player's controls: equal inputs give the same world, to the bit, on one
// kind of machine. A wave begins with a new world, so that memory does not grow: the player's vehicle is
// repaired at its current place, and wrecks and pieces are removed.
class Match {
 public:
  explicit Match(MatchSetup setup);
  // Resumes a match with the same setup at the start of a wave. Precondition: the wave exists.
  Match(MatchSetup setup, const WaveStart& start);

  // Advances by 1/120 s. Once the match is over, the world continues for kAftermath ticks, in which nobody
  // drives, fires or scores, so that airborne bodies land; after that tick() is a no-op.
  void tick(const Controls& player);
  // An enemy aims for kWarning before its first beam, and then fires for kFirstBeam at least [s].
  static constexpr double kWarning = 0.8, kFirstBeam = 0.3;
  static constexpr Ticks kAftermath = 3 * kTicksPerSecond;
  // Returns true if the match and its aftermath are over.
  bool settled() const { return standing().over() && standing().aftermath == kAftermath; }

  // Returns true if the player drives a car without a laser; giving up then loses that car. While the player
  // waits for the next car, giving up ends the wait.
  bool is_disabled() const;

  const Rules& rules() const { return *setup_.rules; }
  const MatchSetup& setup() const { return setup_; }
  const Standing& standing() const { return tally_.standing(); }
  const WaveStart& wave_start() const { return wave_start_; }
  // Time left to win [s].
  double seconds_left() const;
  // The number of times that the player switched the beam on.
  size_t strokes() const { return tally_.strokes(); }

  const World& world() const { return world_.world(); }
  const Physics& physics() const { return world_.physics(); }
  // The vehicles of the wave: the player's, then the enemies, then requested ones.
  static constexpr size_t kPlayer = Tally::kPlayer;
  const std::vector<Vehicle>& vehicles() const { return vehicles_; }
  // Number of other vehicles from which on no requested one is added.
  static constexpr size_t kMaxOthers = 8;
  // Parts that the player cut off and can take for kLootSeconds by driving within kLootReach [m] of them.
  struct LootPart {
    Loot loot;
    BodyId body;
    Ticks until;
  };
  static constexpr double kLootSeconds = 20, kLootReach = 2.5;
  // A part of the arena of this mass [kg] that a beam cut damages the vehicles that it falls on within
  // kFallSeconds.
  static constexpr Interval kFallingMass{kHeavyProp, 4000};
  static constexpr double kFallSeconds = 6;
  const std::vector<LootPart>& loot() const { return loot_; }
  // Returns true if an upgrade was selected in this pause between two waves.
  bool has_upgraded() const { return upgraded_; }
  // The index of the vehicle that a body belongs to, or Event::kNobody.
  size_t vehicle_of(BodyId body) const;
  bool is_wall(BodyId body) const;

  // Changes of the world and events in the last tick.
  const Delta& delta() const { return world_.delta(); }
  const std::vector<Event>& events() const { return tally_.events(); }

  // The view of the driver of a vehicle. Precondition: `sight` is of the current world().
  DriverView view(size_t vehicle, const Sight& sight) const;

 private:
  void begin_wave(const WaveStart& start);
  void add_enemies(const WaveStart& start, Delta& created);
  void spawn();
  void steer_vehicles(const Sight& sight);
  void go_on_afterwards();
  void take_controls(const Controls& player, const Sight& sight);
  void take_turns();
  void announce_beams();
  std::vector<KinematicBody> guided() const;
  std::vector<BodyId> carried() const;
  std::vector<Vec3> velocities() const;
  void move_bodies(PlacementsBefore& before);
  void record_impacts(const std::vector<Vec3>& velocities);
  void crash(size_t vehicle, const Vec3& at, const Vec3& change);
  void fire_beams(const PlacementsBefore& before);
  void separate();
  void follow_fall(const Detached& piece);
  std::vector<Motion> falling_motions() const;
  void strike(const std::vector<Motion>& motions, const PlacementsBefore& before);
  void burst_tanks();
  void push_from(const Vec3& at, size_t burst);
  void assess();
  void pop_off_lost(size_t vehicle, const Damage& damage);
  void recover();
  void armour_player();
  double armour_of_player() const;
  void offer_loot();
  void take_loot();
  bool use_loot(const LootPart& part);
  void count_jump();
  void select_upgrade();
  LaserRules laser_of(size_t vehicle) const;
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
  std::vector<Disc> traffic_;    // at the last update of the drivers
  std::vector<Pilot> pilots_;    // of the enemies
  std::vector<size_t> enemies_;  // indices of vehicles that fight
  std::vector<size_t> numbers_;  // of these, in the wave of the rules
  bool asked_ = false;           // a vehicle was requested in the last tick
  CutTrails trails_;
  // A part of the arena that a beam cut.
  struct FallingBody {
    BodyId body;
    size_t by;                   // vehicle whose beam cut it
    Ticks until;                 // see kFallSeconds
    std::vector<size_t> struck;  // vehicles
  };
  std::map<BodyId, size_t> cutters_;  // by body of no vehicle, the vehicle that last cut it
  std::vector<FallingBody> falling_;
  std::set<std::pair<BodyId, size_t>> struck_by_;  // props as loaded whose fall scored, and the vehicles hit
  std::vector<size_t> bursting_;                   // vehicles whose fuel tanks were cut in the last tick
  std::vector<LootPart> loot_;
  Ticks in_air_ = 0;          // since a wheel of the player's car was on the ground, or the car was recovered
  bool upgraded_ = false;     // an upgrade was selected in this pause
  std::vector<Vec3> thrown_;  // m/s, by vehicle, of pieces that come off in this tick by a crash
};

// Plays the player's side of a match: attacks one vehicle after the other, with short reaction time and
// accurate aim.
class BotPlayer {
 public:
  explicit BotPlayer(const Match& match);

  // Returns the controls for the next tick. Call once per tick.
  Controls next(const Match& match);

 private:
  Pilot pilot_;
};

}  // namespace kerf
