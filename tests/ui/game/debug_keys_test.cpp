#include "ui/game/player_input.h"

#include <gtest/gtest.h>

#include <set>

namespace kerf {
namespace {

TEST(DebugKeys, each_digit_toggles_a_debug_view_and_zero_disables_all) {
  std::set<SwitchId> flipped;
  for (char digit = '1'; digit <= '9'; ++digit) {
    ViewOptions look;
    EXPECT_NE(press_digit(digit, look), "") << digit;
    for (const ViewSwitch& s : view_switches()) {
      if (s.get(look) == s.get(ViewOptions())) continue;
      EXPECT_TRUE(is_debug_view(s)) << s.label;
      EXPECT_EQ(digit_of(s.id), digit) << s.label;
      EXPECT_TRUE(flipped.insert(s.id).second) << s.label;
    }
    press_digit(digit, look);
    for (const ViewSwitch& s : view_switches()) EXPECT_EQ(s.get(look), s.get(ViewOptions())) << s.label;
  }
  EXPECT_EQ(flipped.size(), 9u);
  ViewOptions look;
  for (char digit = '1'; digit <= '9'; ++digit) press_digit(digit, look);
  press_digit('0', look);
  for (const ViewSwitch& s : view_switches()) EXPECT_EQ(s.get(look), s.get(ViewOptions())) << s.label;
}

}  // namespace
}  // namespace kerf
