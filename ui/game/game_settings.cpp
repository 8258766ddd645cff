#include "ui/game/game_settings.h"

#include <array>

#include "core/base/user_folders.h"
#include "ui/window/kept_fields.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

constexpr std::array kDifficulties{"easy", "normal", "hard"};
constexpr std::array kPresets{"automatic", "low", "medium", "high"};

}  // namespace

static void describe(KeptFields& f, GameSettings& s) {
  f.any("version", 1, [](const nlohmann::json&) {});
  f.number("sensitivity", s.sensitivity, GameSettings::kLeastSensitivity, GameSettings::kMostSensitivity);
  f.flag("invert", s.invert);
  f.number("field_of_view", s.field_of_view, GameSettings::kLeastView, GameSettings::kMostView);
  f.number("volume", s.volume, 0, 1);
  f.flag("aim_help", s.aim_help);
  f.flag("guide", s.guide);
  f.flag("show_speed", s.show_speed);
  f.flag("shake", s.shake);
  f.flag("taught", s.taught);
  f.choice("mode", s.mode, kModeNames);
  f.choice("vehicle", s.vehicle, kVehicleNames);
  f.choice("difficulty", s.difficulty, kDifficulties);
  f.choice("preset", s.preset, kPresets);
}

fs::path game_settings_file() { return settings_folder() / "game.json"; }

GameSettings read_game_settings(const fs::path& file) {
  GameSettings settings;
  std::string fault;
  nlohmann::json json = read_kept(file, fault);
  KeptFields fields(json, KeptFields::Way::kRead);
  describe(fields, settings);
  return settings;
}

GameSettings settings_to_keep(const GameSettings& now, const GameSettings& kept,
                              std::optional<Difficulty>& asked) {
  GameSettings keep = now;
  if (asked != now.difficulty) asked.reset();
  if (asked) keep.difficulty = kept.difficulty;
  return keep;
}

Status write_game_settings(const GameSettings& settings, const fs::path& file) {
  nlohmann::json json = nlohmann::json::object();
  GameSettings written = settings;
  KeptFields fields(json, KeptFields::Way::kWrite);
  describe(fields, written);
  return write_kept(json, file);
}

}  // namespace kerf
