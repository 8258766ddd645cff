#include "ui/game/game_settings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

TEST(GameSettings, round_trip) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "kerf" / "game.json";
  GameSettings s;
  s.sensitivity = 1.75;
  s.invert = true;
  s.field_of_view = 71;
  s.volume = 0.25;
  s.aim_help = s.guide = s.shake = false;
  s.taught = true;
  s.mode = GameMode::kTrial;
  s.vehicle = OwnVehicle::kVan;
  s.arena = GameArena::kDepot;
  s.difficulty = Difficulty::kHard;
  s.preset = PicturePreset::kMedium;
  ASSERT_TRUE(write_game_settings(s, file).ok());
  EXPECT_EQ(read_game_settings(file), s);
}

TEST(GameSettings, invalid_values_become_defaults_or_are_clamped) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "game.json";
  std::ofstream(file) << R"({"sensitivity": 99, "volume": "loud", "preset": "best", "invert": 1})";
  const GameSettings s = read_game_settings(file);
  EXPECT_EQ(s.sensitivity, GameSettings::kMaxSensitivity);
  EXPECT_EQ(s.volume, GameSettings().volume);
  EXPECT_EQ(s.preset, PicturePreset::kAutomatic);
  EXPECT_FALSE(s.invert);
}

TEST(GameSettings, invalid_json_is_set_aside) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "game.json";
  std::ofstream(file) << "not json";
  EXPECT_EQ(read_game_settings(file), GameSettings());
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "game.json.bad"));
}

// A folder cannot be read as a file, whoever runs the test.
TEST(GameSettings, unreadable_file_is_set_aside) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "game.json";
  std::filesystem::create_directory(file);
  EXPECT_EQ(read_game_settings(file), GameSettings());
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "game.json.bad"));
  EXPECT_TRUE(write_game_settings({}, file).ok());
}

TEST(GameSettings, do_not_store_a_command_line_difficulty) {
  GameSettings kept, now;
  kept.difficulty = Difficulty::kEasy;
  now.difficulty = Difficulty::kHard;
  now.volume = 0.25;
  std::optional<Difficulty> requested = Difficulty::kHard;
  kept = settings_to_keep(now, kept, requested);
  EXPECT_EQ(kept.difficulty, Difficulty::kEasy);
  EXPECT_EQ(kept.volume, 0.25);
  now.difficulty = Difficulty::kNormal;
  kept = settings_to_keep(now, kept, requested);
  EXPECT_EQ(kept, now);
  now.difficulty = Difficulty::kHard;
  EXPECT_EQ(settings_to_keep(now, kept, requested), now);
}

}  // namespace
}  // namespace kerf
