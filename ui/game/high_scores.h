#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace kerf {

// The result of a match that was played to its end.
struct HighScore {
  double score = 0;
  std::string rules, difficulty;
  bool won = false;
  size_t enemies_destroyed = 0;
  double seconds = 0;  // that the match took
  friend bool operator==(const HighScore&, const HighScore&) = default;
};

inline constexpr size_t kMostHighScores = 10;  // that are kept of each pair of rules and difficulty

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
