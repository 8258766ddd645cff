#include "ui/game/high_scores.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/user_folders.h"
#include "core/document/text/json_value.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bool same_game(const HighScore& a, const HighScore& b) {
  return a.rules == b.rules && a.difficulty == b.difficulty;
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

}  // namespace

fs::path high_scores_file() { return state_folder() / "scores.json"; }

std::vector<HighScore> read_high_scores(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return {};
  const auto text = read_text_file(file);
  if (!text) return {};
  std::vector<HighScore> scores;
  try {
    const auto json = parse_json(*text, file.string());
    if (json && json->is_object()) {
      for (const auto& entry : json->at("scores")) scores.push_back(score_from(entry));
      return scores;
    }
  } catch (const nlohmann::json::exception&) {
    scores.clear();
  }
  fs::rename(file, fs::path(file) += ".bad", error);
  return {};
}

Result<size_t> add_high_score(const HighScore& score, const fs::path& file) {
  std::vector<HighScore> scores = read_high_scores(file);
  const auto better = [&](const HighScore& s) { return same_game(s, score) && s.score >= score.score; };
  const size_t rank = 1 + static_cast<size_t>(std::count_if(scores.begin(), scores.end(), better));
  if (rank > kMostHighScores) return size_t{0};
  scores.push_back(score);
  std::stable_sort(scores.begin(), scores.end(),
                   [](const HighScore& a, const HighScore& b) { return a.score > b.score; });
  size_t kept = 0;
  std::erase_if(scores, [&](const HighScore& s) { return same_game(s, score) && ++kept > kMostHighScores; });
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
  if (error) return failed(file.parent_path().string() + ": the folder for the scores cannot be made");
  if (const Status written = write_file_atomically(file, json.dump(2) + "\n"); !written)
    return written.error();
  return rank;
}

std::vector<HighScore> high_scores_of(const std::string& rules, const std::string& difficulty,
                                      const std::filesystem::path& file) {
  std::vector<HighScore> scores = read_high_scores(file);
  std::erase_if(scores, [&](const HighScore& s) { return s.rules != rules || s.difficulty != difficulty; });
  return scores;
}

}  // namespace kerf
