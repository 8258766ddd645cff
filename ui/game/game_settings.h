#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/game/match/rules.h"
#include "ui/game/game_actions.h"

namespace kerf {

enum class GameMode {
  kWaves,    // the standard match
  kTrial,    // dismantling a vehicle against the clock
  kSandbox,  // no enemies; vehicles to cut appear on request
};
inline constexpr std::array kModeNames{"waves", "trial", "sandbox"};
inline constexpr std::array kModeTitles{"Waves", "Time Trial", "Sandbox"};

enum class OwnVehicle { kHatchback, kBuggy, kPickup, kVan };
inline constexpr std::array kVehicleNames{"hatchback", "buggy", "pickup", "van"};
inline constexpr std::array kVehicleTitles{"Hatchback", "Buggy", "Pick-up", "Van"};

enum class GameArena { kYard, kDepot };
inline constexpr std::array kArenaNames{"yard", "depot"};
inline constexpr std::array kArenaTitles{"Yard", "Depot"};

// The file of an arena of the game.
std::filesystem::path arena_file(GameArena arena);

// Loads the rules of a mode with an arena and the player's vehicle. Fails like load_rules().
Result<std::shared_ptr<const Rules>> load_mode(GameMode mode, GameArena arena, OwnVehicle vehicle);

// Loads the rules of the tutorial (see Lesson).
Result<std::shared_ptr<const Rules>> load_lesson(OwnVehicle vehicle);

enum class PicturePreset {
  kAutomatic,  // the best one that is fast enough on this machine
  kLow,        // half the resolution or more (see ResolutionChoice), no shadows, no anti-aliasing
  kMedium,     // shadows, no anti-aliasing
  kHigh,       // shadows and anti-aliasing
};

// Settings that the game keeps between sessions.
struct GameSettings {
  double sensitivity = 1;     // of the aim, relative to the default
  bool invert = false;        // moving the mouse away aims downwards
  double field_of_view = 62;  // degrees, vertical
  double volume = 0.7;        // 0 .. 1
  bool aim_help = true;
  bool guide = true;         // shows the guide at the beginning of a match
  bool show_speed = false;   // shows frames per second
  bool shake = true;         // camera shake in crashes
  bool taught = false;       // the tutorial was finished or skipped
  bool debug_views = false;  // the keys 1 to 9 switch them
  KeyBindings keys = default_bindings();
  Difficulty difficulty = Difficulty::kNormal;
  GameMode mode = GameMode::kWaves;
  GameArena arena = GameArena::kYard;
  OwnVehicle vehicle = OwnVehicle::kHatchback;
  PicturePreset preset = PicturePreset::kAutomatic;

  static constexpr double kMinSensitivity = 0.2, kMaxSensitivity = 4;
  static constexpr double kMinView = 40, kMaxView = 95;
  friend bool operator==(const GameSettings&, const GameSettings&) = default;
};

// The file of the settings, next to that of the editor.
std::filesystem::path game_settings_file();

// Reads the settings. A missing or damaged file and invalid values give defaults; a file that is damaged or
// cannot be read is renamed with ".bad" appended.
GameSettings read_game_settings(const std::filesystem::path& file);

// Returns the settings to save after a session. A difficulty requested for this session alone is not saved:
// the one in `kept` stays until the player selects another one, which resets `asked`.
GameSettings settings_to_keep(const GameSettings& now, const GameSettings& kept,
                              std::optional<Difficulty>& asked);

// Writes the settings atomically and creates missing folders.
Status write_game_settings(const GameSettings& settings, const std::filesystem::path& file);

struct HighScore {
  double score = 0;
  std::string rules, difficulty;
  bool won = false;
  size_t enemies_destroyed = 0;
  double seconds = 0;  // duration of the match
  friend bool operator==(const HighScore&, const HighScore&) = default;
};

inline constexpr size_t kMaxHighScores = 10;  // kept for each pair of rules and difficulty

// The file of the scores, below state_folder().
std::filesystem::path high_scores_file();

// Reads the scores, best first. A missing file gives none; one that is damaged or cannot be read is renamed
// with ".bad" appended.
std::vector<HighScore> read_high_scores(const std::filesystem::path& file);

// Returns the scores with these rules and this difficulty; with an empty one, those of all difficulties.
std::vector<HighScore> high_scores_of(const std::string& rules, const std::string& difficulty,
                                      const std::filesystem::path& file);

// Adds a score to the file, which is replaced atomically. Returns its rank among those of its rules and
// difficulty, from 1; 0 if it is not among the best. Fails, without writing, if a file that cannot be read
// cannot be renamed either.
Result<size_t> add_high_score(const HighScore& score, const std::filesystem::path& file);

}  // namespace kerf
