#include "ui/game/game_settings.h"

#include <algorithm>

#include "core/base/json.h"
#include "core/base/platform.h"
#include "core/document/text/json.h"
#include "ui/window/kept_fields.h"

namespace kerf {

namespace {

Result<std::shared_ptr<const Rules>> load(const char* rules, GameArena arena, OwnVehicle vehicle) {
  const std::string name = kVehicleNames[static_cast<size_t>(vehicle)];
  return load_rules(assets_folder() / "games" / rules, nullptr,
                    assets_folder() / "vehicles" / (name + ".json"), arena_file(arena));
}

namespace fs = std::filesystem;

constexpr std::array kDifficulties{"easy", "normal", "hard"};
constexpr std::array kPresets{"automatic", "low", "medium", "high"};

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// A game without difficulties has an empty one.
bool is_of_game(const HighScore& score, const std::string& rules, const std::string& difficulty) {
  return score.rules == rules && (difficulty.empty() || score.difficulty == difficulty);
}

void describe_keys(KeptFields& f, KeyBindings& keys) {
  nlohmann::json written = nlohmann::json::object();
  for (size_t i = 0; i < kGameActions; ++i) written[action_keys(static_cast<GameAction>(i)).id] = keys[i];
  f.any("keys", written, [&](const nlohmann::json& value) {
    if (!value.is_object()) return;
    for (size_t i = 0; i < kGameActions; ++i) {
      const auto at = value.find(action_keys(static_cast<GameAction>(i)).id);
      if (at != value.end() && at->is_number_integer())
        bind(static_cast<GameAction>(i), at->get<int>(), keys);
    }
  });
}

HighScore score_from(const nlohmann::json& json) {
  HighScore s;
  s.score = json.value("score", 0.0);
  s.rules = json.value("rules", "");
  s.difficulty = json.value("difficulty", "");
  s.won = json.value("won", false);
  s.enemies_destroyed = json.value("enemies_destroyed", size_t{0});
  s.seconds = json.value("seconds", 0.0);
  return s;
}

// Returns nullopt if the file is damaged or cannot be read.
std::optional<std::vector<HighScore>> scores_in(const fs::path& file) {
  const auto text = read_text_file(file);
  if (!text) return std::nullopt;
  try {
    const auto json = parse_json(*text, file.string());
    if (!json || !json->is_object()) return std::nullopt;
    std::vector<HighScore> scores;
    for (const auto& entry : json->at("scores")) scores.push_back(score_from(entry));
    return scores;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

// Fails if the file cannot be read or set aside.
Result<std::vector<HighScore>> load_high_scores(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return std::vector<HighScore>();
  if (auto scores = scores_in(file)) return std::move(*scores);
  if (!set_aside(file)) return failed(file.string() + ": the scores cannot be read or set aside");
  return std::vector<HighScore>();
}

}  // namespace

std::filesystem::path arena_file(GameArena arena) {
  return assets_folder() / "arenas" / (std::string(kArenaNames[static_cast<size_t>(arena)]) + ".json");
}

Result<std::shared_ptr<const Rules>> load_mode(GameMode mode, GameArena arena, OwnVehicle vehicle) {
  static constexpr std::array kRules{"standard.json", "trial.json", "sandbox.json"};
  return load(kRules[static_cast<size_t>(mode)], arena, vehicle);
}

Result<std::shared_ptr<const Rules>> load_lesson(OwnVehicle vehicle) {
  return load("lesson.json", GameArena::kYard, vehicle);
}

static void describe(KeptFields& f, GameSettings& s) {
  f.any("version", 1, [](const nlohmann::json&) {});
  f.number("sensitivity", s.sensitivity, GameSettings::kMinSensitivity, GameSettings::kMaxSensitivity);
  f.flag("invert", s.invert);
  f.number("field_of_view", s.field_of_view, GameSettings::kMinView, GameSettings::kMaxView);
  f.number("volume", s.volume, 0, 1);
  f.flag("aim_help", s.aim_help);
  f.flag("guide", s.guide);
  f.flag("show_speed", s.show_speed);
  f.flag("shake", s.shake);
  f.flag("taught", s.taught);
  f.flag("debug_views", s.debug_views);
  describe_keys(f, s.keys);
  f.choice("mode", s.mode, kModeNames);
  f.choice("arena", s.arena, kArenaNames);
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

fs::path high_scores_file() { return state_folder() / "scores.json"; }

std::vector<HighScore> read_high_scores(const fs::path& file) {
  const auto scores = load_high_scores(file);
  return scores ? *scores : std::vector<HighScore>();
}

Result<size_t> add_high_score(const HighScore& score, const fs::path& file) {
  auto loaded = load_high_scores(file);
  if (!loaded) return loaded.error();
  std::vector<HighScore>& scores = *loaded;
  const auto better = [&](const HighScore& s) {
    return is_of_game(s, score.rules, score.difficulty) && s.score >= score.score;
  };
  const size_t rank = 1 + static_cast<size_t>(std::count_if(scores.begin(), scores.end(), better));
  if (rank > kMaxHighScores) return size_t{0};
  scores.push_back(score);
  std::stable_sort(scores.begin(), scores.end(),
                   [](const HighScore& a, const HighScore& b) { return a.score > b.score; });
  size_t kept = 0;
  std::erase_if(scores, [&](const HighScore& s) {
    return is_of_game(s, score.rules, score.difficulty) && ++kept > kMaxHighScores;
  });
  Json json{{"version", 1}, {"scores", Json::array()}};
  for (const HighScore& s : scores)
    json["scores"].push_back({{"score", s.score},
                              {"rules", s.rules},
                              {"difficulty", s.difficulty},
                              {"won", s.won},
                              {"enemies_destroyed", s.enemies_destroyed},
                              {"seconds", s.seconds}});
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error)
    return failed(file.parent_path().string() +
                  ": cannot create the folder for the scores: " + error.message());
  if (const Status written = write_file_atomically(file, json.dump(2) + "\n"); !written)
    return written.error();
  return rank;
}

std::vector<HighScore> high_scores_of(const std::string& rules, const std::string& difficulty,
                                      const std::filesystem::path& file) {
  std::vector<HighScore> scores = read_high_scores(file);
  std::erase_if(scores, [&](const HighScore& s) { return !is_of_game(s, rules, difficulty); });
  return scores;
}

}  // namespace kerf
