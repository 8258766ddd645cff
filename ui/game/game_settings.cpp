#include "ui/game/game_settings.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/base/assert.h"
#include "core/base/atomic_file.h"
#include "core/document/text/json_value.h"
#include "core/game/match/recording.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array kDifficulties{"easy", "normal", "hard"};
constexpr std::array kPresets{"automatic", "low", "medium", "high"};

void take_number(const nlohmann::json& json, const char* key, double low, double high, double& out) {
  const auto found = json.find(key);
  if (found != json.end() && found->is_number()) out = std::clamp(found->get<double>(), low, high);
}

void take_flag(const nlohmann::json& json, const char* key, bool& out) {
  const auto found = json.find(key);
  if (found != json.end() && found->is_boolean()) out = found->get<bool>();
}

template <typename Enum, size_t n>
void take_name(const nlohmann::json& json, const char* key, const std::array<const char*, n>& names,
               Enum& out) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_string()) return;
  const auto name = std::find(names.begin(), names.end(), found->template get<std::string>());
  if (name != names.end()) out = static_cast<Enum>(name - names.begin());
}

}  // namespace

const char* name_of(PicturePreset preset) {
  KERF_ASSERT(static_cast<size_t>(preset) < kPresets.size());
  return kPresets[static_cast<size_t>(preset)];
}

fs::path game_settings_file() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && fs::path(config).is_absolute()) return fs::path(config) / "kerf" / "game.json";
  const char* home = std::getenv("HOME");
  return fs::path(home != nullptr ? home : "/") / ".config" / "kerf" / "game.json";
}

GameSettings read_game_settings(const fs::path& file) {
  GameSettings s;
  std::error_code error;
  if (!fs::exists(file, error)) return s;
  const auto text = read_text_file(file);
  if (!text) return s;
  const auto json = parse_json(*text, file.string());
  if (!json || !json->is_object()) {
    fs::rename(file, fs::path(file) += ".bad", error);
    return s;
  }
  take_number(*json, "sensitivity", GameSettings::kLeastSensitivity, GameSettings::kMostSensitivity,
              s.sensitivity);
  take_flag(*json, "invert", s.invert);
  take_number(*json, "field_of_view", GameSettings::kLeastView, GameSettings::kMostView, s.field_of_view);
  take_number(*json, "volume", 0, 1, s.volume);
  take_flag(*json, "aim_help", s.aim_help);
  take_flag(*json, "guide", s.guide);
  take_name(*json, "difficulty", kDifficulties, s.difficulty);
  take_name(*json, "preset", kPresets, s.preset);
  return s;
}

GameSettings settings_to_keep(const GameSettings& now, const GameSettings& kept,
                              std::optional<Difficulty>& asked) {
  GameSettings keep = now;
  if (asked != now.difficulty) asked.reset();
  if (asked) keep.difficulty = kept.difficulty;
  return keep;
}

Status write_game_settings(const GameSettings& s, const fs::path& file) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) return failed(file.parent_path().string() + ": the folder for the settings cannot be made");
  const Json json{{"version", 1},
                  {"sensitivity", s.sensitivity},
                  {"invert", s.invert},
                  {"field_of_view", s.field_of_view},
                  {"volume", s.volume},
                  {"aim_help", s.aim_help},
                  {"guide", s.guide},
                  {"difficulty", name_of(s.difficulty)},
                  {"preset", name_of(s.preset)}};
  return write_file_atomically(file, json.dump(2) + "\n");
}

}  // namespace kerf
