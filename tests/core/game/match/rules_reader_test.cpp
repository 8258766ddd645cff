#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "core/game/match/rules.h"
#include "tests/support/changed_text.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

TEST(RulesFile, names_the_first_error) {
  const std::string good = R"({"arena": "yard.json", "player": "car.json", "waves": [["car.json"]],
    "laser": {"range": 60, "radius": [0.008, 0.03]}, "difficulties": {"easy": {"aim_error": 6}},
    "times": {"match": 300}, "score": {"kill": 5}})";
  test::TemporaryFolder folder;
  const auto file = folder / "rules.json";
  test::write_text(file, good);
  const auto rules = read_rules(file);
  ASSERT_TRUE(rules) << rules.error().message;
  EXPECT_EQ(rules->times.match, 300);
  EXPECT_NEAR(rules->skills[0].aim_error, radians_of(6), 1e-12);
  for (const test::Wrong& w :
       {test::Wrong{"[[\"car.json\"]]", "[[]]", "/waves/0: must name 1 to"},
        test::Wrong{"\"arena\": \"yard.json\",", "", "needs \"arena\""},
        test::Wrong{"[0.008, 0.03]", "[0, 0.03]", "/laser/radius: must be from"},
        test::Wrong{"\"aim_error\": 6", "\"aim_error\": \"low\"", "/difficulties/easy/aim_error"},
        test::Wrong{"\"match\": 300", "\"match\": 0", "/times/match: must be from"}}) {
    test::write_text(file, test::with(good, w.part, w.other));
    const auto bad = read_rules(file);
    ASSERT_FALSE(bad) << w.expected;
    EXPECT_NE(bad.error().message.find(w.expected), std::string::npos) << bad.error().message;
  }
}

}  // namespace
}  // namespace kerf
