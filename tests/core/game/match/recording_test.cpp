#include "core/game/match/recording.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

size_t lines_of(const std::string& text) {
  return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(Recording, maps_difficulties_to_names) {
  for (const Difficulty d : {Difficulty::kEasy, Difficulty::kNormal, Difficulty::kHard})
    EXPECT_EQ(parse_difficulty(name_of(d)), d);
  EXPECT_FALSE(parse_difficulty("lethal"));
}

TEST(Recording, stores_one_second_per_line_and_merges_equal_ticks) {
  Recording recording;
  recording.rules = "games/rules.json";
  recording.controls.resize(2 * kTicksPerSecond + 10);
  recording.controls[5].throttle = -100;
  const auto text = recording_text(recording, "");
  ASSERT_TRUE(text) << text.error().message;
  EXPECT_EQ(lines_of(*text), 4u) << *text;
  const std::string runs = R"({"inputs":[[5,0,0,0,0,0,0,0],[1,-100,0,0,0,0,0,0],[114,0,0,0,0,0,0,0]]})";
  EXPECT_NE(text->find(runs), std::string::npos) << *text;
  EXPECT_NE(text->find(R"({"inputs":[[10,0,0,0,0,0,0,0]]})"), std::string::npos) << *text;
  recording.hash = 0x123;
  recording.machine = "here";
  EXPECT_EQ(lines_of(*recording_text(recording, "")), 5u);
}

TEST(Recording, stores_all_controls_and_the_selected_car) {
  test::TemporaryFolder folder;
  Recording recording;
  recording.rules = folder / "rules.json";
  recording.player = folder / "van.json";
  recording.arena = folder / "depot.json";
  for (int buttons = 0; buttons < 8; ++buttons) {
    Controls& c = recording.controls.emplace_back();
    c.handbrake = buttons % 2 == 1;
    c.spawn = buttons / 2 % 2 == 1;
    c.give_up = buttons / 4 == 1;
    c.heading = -31'000 + buttons;
  }
  const auto text = recording_text(recording, folder.path());
  ASSERT_TRUE(text);
  test::write_text(folder / "match.kerf", *text);
  const auto read = read_recording(folder / "match.kerf");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->controls, recording.controls);
  EXPECT_EQ(read->player.lexically_normal(), recording.player);
  EXPECT_EQ(read->arena.lexically_normal(), recording.arena);
}

TEST(Recording, stores_a_relative_path_to_its_rules) {
  test::TemporaryFolder folder;
  Recording recording;
  recording.rules = folder / "rules.json";
  EXPECT_NE(recording_text(recording, folder.path())->find(R"("rules":"rules.json")"), std::string::npos);
}

// The rules, and all files that they name, in a folder.
class MatchFiles : public testing::Test {
 protected:
  MatchFiles() {
    const std::string car = R"({"mesh": "car.obj",
      "wheels": [{"part": "wheel", "mount": "axle", "hub": [0, 0.3, 1], "radius": 0.3}],
      "turret": {"part": "turret", "mount": "body", "pivot": [0, 1, 0],
                 "barrel": {"part": "barrel", "pivot": [0, 1, 0], "muzzle": [0, 1, 1]}}})";
    write("rules.json",
          R"({"arena": "arena.json", "player": "car.json", "waves": [["car.json", "van.json"]]})");
    write("arena.json", R"({"bodies": [{"mesh": "wall.obj", "name": "wall"}],
      "starts": {"player": {"position": [0, 0, 0]}, "enemies": [{"position": [0, 0, 9]}]}})");
    write("car.json", car);
    write("van.json", car);
    for (const char* mesh : {"car.obj", "wall.obj"}) write(mesh, "a mesh is not read\n");
  }
  void write(const std::string& name, const std::string& text) { test::write_text(folder_ / name, text); }
  Result<uint64_t> hash() const {
    const auto rules = read_rules(folder_ / "rules.json");
    if (!rules) return rules.error();
    return hash_of_files(folder_ / "rules.json", *rules);
  }

  test::TemporaryFolder folder_;
};

TEST_F(MatchFiles, have_a_hash_that_changes_with_each_of_them) {
  const auto before = hash();
  ASSERT_TRUE(before) << before.error().message;
  EXPECT_EQ(*hash(), *before);
  for (const char* name : {"rules.json", "arena.json", "car.json", "van.json", "car.obj", "wall.obj"}) {
    const std::string text = test::read_text(folder_ / name);
    write(name, text + "\n");
    EXPECT_NE(*hash(), *before) << name;
    write(name, text);
  }
  EXPECT_EQ(*hash(), *before);
}

TEST_F(MatchFiles, have_the_same_hash_by_relative_paths) {
  write("wall.obj", "another mesh\n");
  auto rules = read_rules(folder_ / "rules.json");
  ASSERT_TRUE(rules) << rules.error().message;
  rules->arena = std::filesystem::relative(rules->arena);
  EXPECT_EQ(*hash_of_files(folder_ / "rules.json", *rules), *hash());
}

TEST_F(MatchFiles, have_no_hash_if_any_is_missing) {
  std::filesystem::remove(folder_ / "wall.obj");
  const auto missing = hash();
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("wall.obj"), std::string::npos) << missing.error().message;
}

}  // namespace
}  // namespace kerf
