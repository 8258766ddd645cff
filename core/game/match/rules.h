#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/cut/cut_step.h"
#include "core/game/arena/arena.h"
#include "core/game/vehicle/vehicle.h"
#include "core/game/vehicle/vehicle_model.h"
#include "core/world/world.h"

namespace kerf {

enum class Difficulty { kEasy, kNormal, kHard };

struct EnemySkill {
  double reaction = 0.55;       // s, delay of their perception
  double aim_error = 0.06;      // rad
  double speed = 0.85;          // fraction of the throttle
  double fire = 0.6;            // fraction of the time for which they fire when they could
  double distance = 13;         // m, to keep from their opponent
  size_t max_firing = 12;       // number of them that may fire at the same time
  double min_vital = kMinPart;  // fraction of a vital part of the player's car with which it works
};

struct Scores {
  double piece = 10, wheel = 100, turret = 250, engine = 300, driver = 300, kill = 500;
  double in_halves = 400;      // an enemy is split in two parts of at least a quarter of it
  double at_a_stroke = 600;    // it dies during the stroke that first cut it
  double clean = 0;            // a part comes off whole (see is_clean)
  double air = 0;              // for each second of a jump
  double struck = 800;         // a cut post, gantry or stack falls on an enemy
  double tank = 200;           // its fuel tank bursts
  std::vector<double> medals;  // bronze, silver, gold: the least scores; none if empty
};

struct MatchTimes {
  double match = 600;        // s, time limit
  double between_waves = 6;  // s
  double righting = 3;       // s, for which a vehicle lies before it is put upright
  double stuck = 3;          // s, for which it is stuck before it is moved
};

inline constexpr size_t kMaxEnemies = 12;  // of a wave

// The content of a rules file. The initial values are the defaults of missing keys.
struct RulesDescription {
  std::string name;
  std::filesystem::path arena, player;
  std::vector<std::vector<std::filesystem::path>> waves;  // vehicles of each; none for a sandbox
  std::vector<std::filesystem::path> spawns;              // vehicles to cut that the player can request
  size_t cars = 1;                                        // number of cars of the player, one after the other
  bool targets = false;  // enemies stand still, and the match ends with its time, neither won nor lost
  LaserRules laser;
  MatchTimes times;
  std::array<EnemySkill, 3> skills;  // by Difficulty
  Scores scores;
};

// Reads a rules file:
//
//   {"name": "standard", "arena": "../arenas/yard.json", "player": "../vehicles/hatchback.json",
//    "waves": [["../vehicles/buggy.json"], ["../vehicles/van.json", "../vehicles/buggy.json"]],
//    "laser": {"range": 18, "radius": [0.008, 0.03], "energy": 100, "energy_per_second": 18,
//              "recharge_per_second": 10, "recharge_per_second_driving": 30, "heat_per_second": 0.2,
//              "cooling_per_second": 0.4},
//    "times": {"match": 600, "between_waves": 6, "righting": 3, "stuck": 3},
//    "difficulties": {"easy": {"reaction": 0.9, "aim_error": 6, "enemy_speed": 0.7, "enemy_fire": 0.35,
//                              "enemy_distance": 16, "enemies_at_once": 1,
//                              "player_vital": 0.3},
//                     "normal": {..}, "hard": {..}},
//    "score": {"piece": 10, "wheel": 100, "turret": 250, "engine": 300, "driver": 300, "kill": 500,
//              "in_halves": 400, "at_a_stroke": 600, "clean": 50, "air": 50, "struck": 800, "tank": 200,
//              "medals": [500, 1500, 3000]},
//    "cars": 3, "targets": false, "spawns": ["../vehicles/van.json"]}
//
// Aim errors are in degrees. "recharge_per_second_driving", at 8 m/s or more, defaults to
// "recharge_per_second". Required are "arena", "player" and "waves". Fails with bad input, with the file and
// the JSON pointer. Does not read the other files.
Result<RulesDescription> read_rules(const std::filesystem::path& file);

// Rules with all their files loaded. Immutable; may be shared by many matches.
struct Rules {
  RulesDescription description;
  std::filesystem::path file, player_file, arena_file;  // loaded files (see load_rules)
  Arena arena;
  std::shared_ptr<const VehicleModel> player;
  std::vector<std::vector<std::shared_ptr<const VehicleModel>>> waves;
  std::vector<std::shared_ptr<const VehicleModel>> spawns;
  const EnemySkill& skill(Difficulty d) const { return description.skills[static_cast<size_t>(d)]; }
};

// Reads the rules and loads the arena and the vehicles, each file once. The player drives the vehicle of
// the file `player` in the arena of the file `arena`, or those of the rules if they are empty; another arena
// adds its name to that of the rules. Fails like read_arena, load_arena, read_vehicle
// and load_vehicle, and if the arena has too few starts for a wave. `progress` may be null.
Result<std::shared_ptr<const Rules>> load_rules(const std::filesystem::path& file,
                                                const Progress* progress = nullptr,
                                                const std::filesystem::path& player = {},
                                                const std::filesystem::path& arena = {});

// An event in a tick of a match, for the screen and for statistics.
struct Event {
  enum class Kind {
    kCut,         // a beam removed `size` kg of `body`
    kPieceOff,    // `body` came off, with an area of `size` m^2
    kCleanPart,   // that piece is a part that came off whole
    kWheelLost,   // `part` is the index of the wheel, `body` the wheel
    kTurretLost,  // `body` is the turret
    kBarrelLost,  // `body` is the barrel
    kVitalLost,   // `part` is the index of the vital part
    kTankBurst,   // the fuel tank of `vehicle` was cut
    kStruck,      // `body`, of `size` kg, fell on `vehicle` after a beam had cut it
    kInHalves,    // `body`, a piece of at least a quarter of the chassis, came off
    kKilled,
    kOverheated,   // the laser of `vehicle`
    kImpact,       // the velocity of `vehicle` changed by `size` m/s
    kRighted,      // `vehicle` was put upright (`part` is kFlipped), or moved from where it was stuck
    kWaveBegins,   // `part` is the number of the wave, from 0
    kWaveCleared,  // likewise
    kCarLost,      // the player's; `part` are left
    kLooted,       // the player took a part that lay around; `part` is its Loot
    kJumped,       // the player's car landed after `size` s in the air
    kUpgraded,     // the player's car; `part` is the number of the upgrade
    kNotSpawned,   // no vehicle was added on request; `part` is the maximum number reached, or 0: no room
    kWon,
    kLost,
  };
  static constexpr size_t kNobody = static_cast<size_t>(-1);
  static constexpr size_t kFlipped = 1;

  Kind kind;
  size_t vehicle = kNobody;  // affected vehicle, an index of Match::vehicles()
  size_t by = kNobody;       // vehicle whose beam caused it
  size_t part = 0;
  BodyId body{};
  Vec3 at{0};  // m, in the world
  double size = 0;
  double points = 0;  // that the player got for it
  size_t combo = 1;   // factor of the points, for different parts in quick succession
  Vec3 across{0};     // unit, from the cut towards the part that came off; 0: unknown
};

// Upgrades of the player's car, selected between two waves by Controls::upgrade.
enum class Upgrade : uint8_t {
  kCooling = 1,  // the laser heats up more slowly
  kBattery,      // it charges faster
  kArmour        // vital parts work until less is left of them
};

// What a part that was cut off an enemy is to the player.
enum class Loot : uint8_t {
  kWheel,   // replaces a lost one
  kEngine,  // charges the laser
  kLaser,   // becomes a second beam
  kPlate    // armours vital parts
};

struct Standing {
  enum class Phase {
    kFight,
    kPause,  // a wave is cleared, the next one follows soon
    kDown,   // the player's car is wrecked, the next one follows soon
    kWon,
    kLost,
    kEnded,  // neither: the time of a sandbox is up
  };
  Phase phase = Phase::kFight;
  size_t wave = 0;       // from 0
  Ticks ticks = 0;       // since the start
  Ticks aftermath = 0;   // since the match was over
  Ticks pause_left = 0;  // of kPause and kDown
  size_t cars_left = 0;  // of the player, not counting the current one
  double score = 0;
  size_t enemies_destroyed = 0;
  size_t wheels_lost = 0;  // of the player's vehicles
  size_t pieces = 0;       // that came off bodies
  size_t pieces_cut = 0;   // off enemies by the player
  size_t faces_removed = 0;
  std::array<uint8_t, Controls::kUpgrades> upgrades{};  // how often each one was selected, by Upgrade - 1
  bool over() const { return phase >= Phase::kWon; }
  Ticks elapsed() const { return ticks + aftermath; }
};

// Keeps the score of a match: cuts, points, and the state of the match. Vehicles are identified by their
// index in the wave; the player has index 0.
class Tally {
 public:
  static constexpr size_t kPlayer = 0;
  static constexpr double kComboSeconds = 4;  // between parts that count together
  static constexpr size_t kMaxCombo = 5;

  Tally() = default;
  // `scores`: the points of the rules, which must outlive it. `strokes`: see strokes().
  Tally(const Scores& scores, const Standing& standing, size_t strokes)
      : scores_(&scores), standing_(standing), strokes_(strokes) {}

  Standing& standing() { return standing_; }
  const Standing& standing() const { return standing_; }
  // The number of times that the player switched the beam on.
  size_t strokes() const { return strokes_; }
  void count_stroke() { ++strokes_; }
  const std::vector<Event>& events() const { return events_; }

  void begin_wave(size_t vehicles) {
    records_.assign(vehicles, Record{});
    hits_.clear();
  }
  void add_vehicle() { records_.emplace_back(); }
  void begin_tick() { events_.clear(); }

  // Adds an event of the player alone, with points.
  void award(Event event, double points);
  // Adds an event of a vehicle, with points if the player caused it to an enemy.
  void add_event(Event event, double points = 0);
  // Records that the beam of a vehicle cut a body of the vehicle `victim` (Event::kNobody: of none).
  void record_cut(size_t shooter, size_t victim, BodyId id, const Body& body, const StepResult& cut);
  // Records that the next damage of a vehicle, which must be assessed, is due to another one.
  void blame(size_t victim, size_t by);
  // The vehicle that last caused damage to a vehicle, or Event::kNobody.
  size_t last_cut_by(size_t vehicle) const { return records_[vehicle].last_cut_by; }
  // Records that a piece was detached from a body of `vehicle` (null: of no vehicle). `clean`: see is_clean;
  // `across`: see Event.
  void record_piece(const Detached& piece, const Body& body, size_t victim, const Vehicle* vehicle,
                    bool clean, const Vec3& across = Vec3(0));
  // Returns true, once, after a vehicle was cut or lost a piece, i.e. if its damage must be assessed from its
  // meshes.
  bool takes_assessment(size_t vehicle);
  void record_damage(const World& world, size_t index, const Vehicle& vehicle, const Damage& damage);

 private:
  // Data of a vehicle in addition to its state.
  struct Record {
    size_t last_cut_by = Event::kNobody;
    size_t first_stroke = 0;  // of the player that cut it, from 1; 0 if none did
    bool disarmed = false;    // its laser or barrel was scored
    bool changed = false;     // faces of it changed, or a piece came off, since the last assessment
  };
  // A part that the player cut off an enemy.
  struct Hit {
    Ticks tick;
    Event::Kind kind;
    size_t part;
  };
  size_t combo_of(const Event& event);

  const Scores* scores_ = nullptr;
  Standing standing_;
  size_t strokes_ = 0;
  std::vector<Record> records_;  // by vehicle
  std::vector<Hit> hits_;        // of the last kComboSeconds
  std::vector<Event> events_;
};

// The centre of the bounding box of a body in the world [m].
Vec3 middle_of(const Body& body);

}  // namespace kerf
