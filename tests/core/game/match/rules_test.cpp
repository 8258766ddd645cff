#include "core/game/match/rules.h"

#include <gtest/gtest.h>

#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

// Rules that name vehicles of the assets and an arena beside them.
class AssetRules : public testing::Test {
 protected:
  AssetRules() {
    test::write_text(folder_ / "arena.json", R"({"starts": {"player": {"position": [0, 0, 0]},
      "enemies": [{"position": [0, 0, 20]}, {"position": [5, 0, 20]}]}})");
  }
  static std::string vehicle(const std::string& name) {
    return "\"" + (test::checkout() / "assets/vehicles" / (name + ".json")).string() + "\"";
  }
  Result<std::shared_ptr<const Rules>> load(const std::string& player, const std::string& waves,
                                            const Progress* progress = nullptr) {
    test::write_text(folder_ / "rules.json",
                     R"({"arena": "arena.json", "player": )" + player + R"(, "waves": )" + waves + "}");
    return load_rules(folder_ / "rules.json", progress);
  }

  test::TemporaryFolder folder_;
};

TEST_F(AssetRules, load_each_vehicle_once_and_keep_the_wave_order) {
  const std::string buggy = vehicle("buggy"), van = vehicle("van");
  const auto rules = load(buggy, "[[" + van + "], [" + buggy + ", " + van + "]]");
  ASSERT_TRUE(rules) << rules.error().message;
  const Rules& r = **rules;
  EXPECT_EQ(r.player->description.name, "buggy");
  ASSERT_EQ(r.waves.size(), 2u);
  ASSERT_EQ(r.waves[1].size(), 2u);
  EXPECT_EQ(r.waves[0][0]->description.name, "van");
  EXPECT_EQ(r.waves[1][0], r.player);
  EXPECT_EQ(r.waves[1][1], r.waves[0][0]);
  EXPECT_EQ(r.skill(Difficulty::kHard).max_firing, r.description.skills[2].max_firing);
}

TEST_F(AssetRules, name_a_missing_vehicle_or_arena) {
  const auto without_vehicle = load("\"gone.json\"", "[]");
  ASSERT_FALSE(without_vehicle);
  EXPECT_NE(without_vehicle.error().message.find("gone.json"), std::string::npos);
  std::filesystem::remove(folder_ / "arena.json");
  const auto without_arena = load(vehicle("buggy"), "[]");
  ASSERT_FALSE(without_arena);
  EXPECT_NE(without_arena.error().message.find("arena.json"), std::string::npos);
}

TEST_F(AssetRules, limit_enemies_per_wave_to_the_start_positions) {
  const std::string buggy = vehicle("buggy");
  const auto rules = load(buggy, "[[" + buggy + "], [" + buggy + ", " + buggy + ", " + buggy + "]]");
  ASSERT_FALSE(rules);
  EXPECT_NE(rules.error().message.find("/waves/1: has 3 enemies"), std::string::npos)
      << rules.error().message;
}

TEST_F(AssetRules, reject_unknown_keys_in_rules_and_arena) {
  const auto error_with = [&](const std::string& player, const std::string& more) {
    test::write_text(folder_ / "arena.json", R"({"starts": {"player": {"position": [0, 0, 0])" + player +
                                                 R"(}, "enemies": [{"position": [0, 0, 20]}]}})");
    test::write_text(folder_ / "rules.json", R"({"arena": "arena.json", "player": )" + vehicle("buggy") +
                                                 R"(, "waves": [])" + more + "}");
    const auto rules = load_rules(folder_ / "rules.json");
    return rules ? "" : rules.error().message;
  };
  EXPECT_EQ(error_with("", ""), "");
  const std::string file = (folder_ / "rules.json").string();
  EXPECT_EQ(error_with("", R"(, "times": {"macth": 3})"),
            file + ": /times/macth: is not a valid key here in this version; the nearest name is \"match\"");
  EXPECT_NE(error_with("", R"(, "naem": "x")").find("/naem"), std::string::npos);
  EXPECT_NE(error_with(R"(, "haeding": 3)", "").find("/starts/player/haeding"), std::string::npos);
}

TEST_F(AssetRules, loading_can_be_cancelled) {
  const Progress stopped{[](double) { return false; }};
  const auto rules = load(vehicle("buggy"), "[]", &stopped);
  ASSERT_FALSE(rules);
  EXPECT_EQ(rules.error().message, cancelled().message);
}

}  // namespace
}  // namespace kerf
