#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/game/arena/arena.h"
#include "core/game/vehicle/laser_gun.h"
#include "core/game/vehicle/vehicle_model.h"

namespace kerf {

enum class Difficulty { kEasy, kNormal, kHard };

struct EnemySkill {
  double reaction = 0.55;   // s, delay of their perception
  double aim_error = 0.06;  // rad
  double speed = 0.85;      // fraction of the throttle
  double fire = 0.6;        // fraction of the time for which they fire when they could
  double distance = 13;     // m, to keep from their opponent
  size_t max_firing = 12;   // number of them that may fire at the same time
};

struct Scores {
  double piece = 10, wheel = 100, turret = 250, engine = 300, driver = 300, kill = 500;
  double in_halves = 400;    // an enemy is split in two parts of at least a quarter of it
  double at_a_stroke = 600;  // it dies during the stroke that first cut it
  double clean = 0;          // a part comes off whole (see is_clean)
};

struct MatchTimes {
  double match = 600;        // s, time limit
  double between_waves = 6;  // s
  double righting = 3;       // s, for which a vehicle lies before it is put upright
  double stuck = 3;          // s, for which it is stuck before it is moved
};

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
//                              "enemy_distance": 16, "enemies_at_once": 1},
//                     "normal": {..}, "hard": {..}},
//    "score": {"piece": 10, "wheel": 100, "turret": 250, "engine": 300, "driver": 300, "kill": 500,
//              "in_halves": 400, "at_a_stroke": 600, "clean": 50},
//    "cars": 3, "targets": false, "spawns": ["../vehicles/van.json"]}
//
// Aim errors are in degrees. "recharge_per_second_driving", at 8 m/s or more, defaults to
// "recharge_per_second". Required are "arena", "player" and "waves". Bad input otherwise, with the file and
// the JSON pointer. Does not read the other files.
Result<RulesDescription> read_rules(const std::filesystem::path& file);

// Rules with all their files loaded. Immutable; may be shared by many matches.
struct Rules {
  RulesDescription description;
  std::filesystem::path file, player_file;  // loaded files (see load_rules)
  Arena arena;
  std::shared_ptr<const VehicleModel> player;
  std::vector<std::vector<std::shared_ptr<const VehicleModel>>> waves;
  std::vector<std::shared_ptr<const VehicleModel>> spawns;
  const EnemySkill& skill(Difficulty d) const { return description.skills[static_cast<size_t>(d)]; }
};

// Reads the rules and loads the arena and the vehicles, each file once. The player drives the vehicle of
// the file `player`, or that of the rules if it is empty. Fails like read_arena, load_arena, read_vehicle
// and load_vehicle, and if the arena has too few starts for a wave. `progress` may be null.
Result<std::shared_ptr<const Rules>> load_rules(const std::filesystem::path& file,
                                                const Progress* progress = nullptr,
                                                const std::filesystem::path& player = {});

}  // namespace kerf
