#include "ui/editor/shell/command_palette.h"

#include <gtest/gtest.h>

#include <string>

#include "core/base/random.h"

namespace kerf {
namespace {

TEST(FuzzyScore, finds_letters_of_a_word_in_order_in_any_case) {
  EXPECT_TRUE(fuzzy_score("wre", "Wireframe").has_value());
  EXPECT_TRUE(fuzzy_score("WIRE", "Wireframe").has_value());
  EXPECT_FALSE(fuzzy_score("erw", "Wireframe").has_value());
  EXPECT_FALSE(fuzzy_score("wirewire", "Wireframe").has_value());
  EXPECT_FALSE(fuzzy_score("a", "").has_value());
}

TEST(FuzzyScore, accepts_words_in_any_order_and_an_empty_query) {
  EXPECT_TRUE(fuzzy_score("selected hide", "Hide Selected").has_value());
  EXPECT_FALSE(fuzzy_score("chosen show", "Hide Selected").has_value());
  EXPECT_EQ(fuzzy_score("", "anything"), 0);
  EXPECT_EQ(fuzzy_score("   ", ""), 0);
}

TEST(FuzzyScore, prefers_word_starts_and_consecutive_letters) {
  EXPECT_GT(fuzzy_score("sv", "Shadow Volumes"), fuzzy_score("sv", "Dissolves"));
  EXPECT_GT(fuzzy_score("wire", "Wireframe"), fuzzy_score("wire", "Wider eaves"));
  EXPECT_GT(fuzzy_score("un", "Undo"), fuzzy_score("un", "Save as a new one"));
}

// The definition of a subsequence, letter by letter.
bool is_subsequence(const std::string& word, const std::string& text) {
  size_t next = 0;
  for (const char c : text) next += next < word.size() && word[next] == c ? 1 : 0;
  return next == word.size();
}

TEST(FuzzyScore, matches_exactly_the_subsequences) {
  Random random(17);
  const auto random_word = [&](size_t most) {
    std::string word;
    for (size_t n = random.below(most + 1); n > 0; --n) word += static_cast<char>('a' + random.below(3));
    return word;
  };
  for (int round = 0; round < 2000; ++round) {
    const std::string word = random_word(4), text = random_word(10);
    EXPECT_EQ(fuzzy_score(word, text).has_value(), is_subsequence(word, text)) << word << " in " << text;
  }
}

}  // namespace
}  // namespace kerf
