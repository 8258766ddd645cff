#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/game/match/rules.h"

namespace kerf {

// What is played.
enum class GameMode {
  kWaves,    // the standard match
  kTrial,    // a vehicle to take apart against the clock
  kSandbox,  // no enemies; vehicles to cut come when they are asked for
};
inline constexpr std::array kModeNames{"waves", "trial", "sandbox"};
inline constexpr std::array kModeTitles{"Waves", "Time trial", "Sandbox"};

// What the player drives.
enum class OwnVehicle { kHatchback, kBuggy, kPickup, kVan };
inline constexpr std::array kVehicleNames{"hatchback", "buggy", "pickup", "van"};
inline constexpr std::array kVehicleTitles{"Hatchback", "Buggy", "Pick-up", "Van"};

// Loads the rules of a mode with the vehicle that the player drives. Fails like load_rules().
Result<std::shared_ptr<const Rules>> load_mode(GameMode mode, OwnVehicle vehicle);

// Loads the rules of the lesson (see Lesson).
Result<std::shared_ptr<const Rules>> load_lesson(OwnVehicle vehicle);

// How much the pictures of the game cost.
enum class PicturePreset {
  kAutomatic,  // the best one that is fast enough here
  kLow,        // half the resolution or more (see ResolutionChoice), no shadows, no anti-aliasing
  kMedium,     // shadows, no anti-aliasing
  kHigh,       // shadows and anti-aliasing
};

// Settings that the game keeps between sessions.
struct GameSettings {
  double sensitivity = 1;     // of the aim, relative to the usual one
  bool invert = false;        // moving the mouse away aims downwards
  double field_of_view = 62;  // degrees, vertical
  double volume = 0.7;        // 0 .. 1
  bool aim_help = true;
  bool guide = true;        // the guide is shown at the beginning of a match
  bool show_speed = false;  // frames a second are shown
  bool shake = true;        // the camera shakes in crashes
  bool taught = false;      // the lesson was done or skipped
  Difficulty difficulty = Difficulty::kNormal;
  GameMode mode = GameMode::kWaves;
  OwnVehicle vehicle = OwnVehicle::kHatchback;
  PicturePreset preset = PicturePreset::kAutomatic;

  static constexpr double kMinSensitivity = 0.2, kMaxSensitivity = 4;
  static constexpr double kMinView = 40, kMaxView = 95;
  friend bool operator==(const GameSettings&, const GameSettings&) = default;
};

// The file of the settings, beside that of the editor.
std::filesystem::path game_settings_file();

// Reads the settings. A missing or damaged file and invalid values give defaults; a damaged file is renamed
// with ".bad" appended.
GameSettings read_game_settings(const std::filesystem::path& file);

// Returns what to keep of the settings of a session. A difficulty that was asked for this session alone is
// not kept: the difficulty in `kept` stays until the player chooses another one, which empties `asked`.
GameSettings settings_to_keep(const GameSettings& now, const GameSettings& kept,
                              std::optional<Difficulty>& asked);

// Writes the settings, whole or not at all, and creates missing folders.
Status write_game_settings(const GameSettings& settings, const std::filesystem::path& file);

// The result of a match that was played to its end.
struct HighScore {
  double score = 0;
  std::string rules, difficulty;
  bool won = false;
  size_t enemies_destroyed = 0;
  double seconds = 0;  // that the match took
  friend bool operator==(const HighScore&, const HighScore&) = default;
};

inline constexpr size_t kMaxHighScores = 10;  // that are kept of each pair of rules and difficulty

// The file of the scores, below state_folder().
std::filesystem::path high_scores_file();

// Reads the scores, best first. A missing file gives none; one that is damaged is renamed with ".bad"
// appended.
std::vector<HighScore> read_high_scores(const std::filesystem::path& file);

// Those of them with these rules and this difficulty.
std::vector<HighScore> high_scores_of(const std::string& rules, const std::string& difficulty,
                                      const std::filesystem::path& file);

// Adds a score to the file, which is replaced whole or not at all. Returns its rank among those of its rules
// and difficulty, from 1; 0 if it is not among the best.
Result<size_t> add_high_score(const HighScore& score, const std::filesystem::path& file);

}  // namespace kerf
