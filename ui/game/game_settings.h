#pragma once

#include <filesystem>
#include <optional>

#include "core/base/result.h"
#include "ui/game/game_modes.h"

namespace kerf {

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

  static constexpr double kLeastSensitivity = 0.2, kMostSensitivity = 4;
  static constexpr double kLeastView = 40, kMostView = 95;
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

}  // namespace kerf
