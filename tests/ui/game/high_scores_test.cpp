#include "ui/game/game_settings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

HighScore score(double points, const char* difficulty = "easy") {
  return {points, "standard", difficulty, points > 500, 3, 120};
}

TEST(HighScores, keep_the_best_of_each_game_in_order) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "state" / "scores.json";
  for (int i = 1; i <= 12; ++i) EXPECT_EQ(*add_high_score(score(100.0 * i), file), 1u);
  EXPECT_EQ(*add_high_score(score(950), file), 4u);
  EXPECT_EQ(*add_high_score(score(1), file), 0u);
  EXPECT_EQ(*add_high_score(score(1, "hard"), file), 1u);
  const auto all = read_high_scores(file);
  ASSERT_EQ(all.size(), kMaxHighScores + 1);
  EXPECT_EQ(all.front(), score(1200));
  for (size_t i = 1; i < all.size(); ++i) EXPECT_GE(all[i - 1].score, all[i].score);
}

TEST(HighScores, damaged_file_is_set_aside) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "scores.json";
  for (const char* text : {"{\"scores\": [", "[]", "{}", "{\"scores\": [7]}", ""}) {
    std::ofstream(file) << text;
    EXPECT_TRUE(read_high_scores(file).empty()) << text;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "scores.json.bad")) << text;
    EXPECT_FALSE(std::filesystem::exists(file)) << text;
    EXPECT_EQ(*add_high_score(score(5), file), 1u) << text;
    std::filesystem::remove(file);
  }
}

// A folder cannot be read as a file, whoever runs the test.
TEST(HighScores, unreadable_file_is_set_aside) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "scores.json";
  std::filesystem::create_directory(file);
  const auto rank = add_high_score(score(5), file);
  ASSERT_TRUE(rank) << rank.error().message;
  EXPECT_EQ(*rank, 1u);
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "scores.json.bad"));
}

TEST(HighScores, damaged_file_that_cannot_be_set_aside_is_not_replaced) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "scores.json";
  const std::string damaged = "{\"scores\": [";
  std::ofstream(file) << damaged;
  std::filesystem::create_directory(folder.path() / "scores.json.bad");
  EXPECT_TRUE(read_high_scores(file).empty());
  EXPECT_FALSE(add_high_score(score(5), file));
  std::ifstream stream(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), damaged);
}

}  // namespace
}  // namespace kerf
