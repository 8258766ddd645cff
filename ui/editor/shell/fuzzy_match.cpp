#include "ui/editor/shell/fuzzy_match.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace kerf {

namespace {

constexpr int kNone = std::numeric_limits<int>::min() / 2;
constexpr int kLetter = 1, kInARow = 7, kBeginsWord = 6, kBeginsText = 2;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_part_of_word(char c) {
  return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9') ||
         static_cast<unsigned char>(c) > 127;
}

bool begins_word(std::string_view text, size_t at) {
  return at == 0 || (is_part_of_word(text[at]) && !is_part_of_word(text[at - 1]));
}

int score_of_letter(std::string_view text, size_t at) {
  return kLetter + (begins_word(text, at) ? kBeginsWord : 0) + (at == 0 ? kBeginsText : 0);
}

// Dynamic programming over the letters of the word: ends[i] is the best score of the letters so far whose
// last one is matched by text[i].
std::optional<int> score_of_word(std::string_view word, std::string_view text) {
  std::vector<int> ends(text.size(), kNone);
  for (size_t letter = 0; letter < word.size(); ++letter) {
    std::vector<int> next(text.size(), kNone);
    int best_before = letter == 0 ? 0 : kNone;  // of the letters before, anywhere left of i
    for (size_t i = 0; i < text.size(); ++i) {
      if (lower(text[i]) == lower(word[letter])) {
        const int row = letter > 0 && i > 0 ? ends[i - 1] + kInARow : kNone;
        const int before = std::max(best_before, row);
        if (before > kNone / 2) next[i] = before + score_of_letter(text, i);
      }
      if (letter > 0) best_before = std::max(best_before, ends[i]);
    }
    ends = std::move(next);
  }
  const auto best = std::max_element(ends.begin(), ends.end());
  return best == ends.end() || *best <= kNone / 2 ? std::nullopt : std::optional(*best);
}

}  // namespace

std::optional<int> fuzzy_score(std::string_view query, std::string_view text) {
  int score = 0;
  while (true) {
    const size_t from = query.find_first_not_of(' ');
    if (from == std::string_view::npos) return score;
    const size_t to = std::min(query.find(' ', from), query.size());
    const auto word = score_of_word(query.substr(from, to - from), text);
    if (!word) return std::nullopt;
    score += *word;
    query.remove_prefix(to);
  }
}

}  // namespace kerf
