#include "ui/render/view/view_options.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace kerf {
namespace {

TEST(ViewSwitches, are_in_the_order_of_their_ids) {
  for (const ViewSwitch& s : view_switches()) EXPECT_EQ(&view_switch(s.id), &s) << s.report;
}

TEST(ViewSwitches, each_toggles_one_flag_and_cycles_through_its_states) {
  for (const ViewSwitch& flipped : view_switches()) {
    ViewOptions look;
    const size_t before = flipped.get(look);
    flipped.flip(look);
    for (const ViewSwitch& other : view_switches()) {
      EXPECT_EQ(other.get(look) != other.get(ViewOptions()), other.id == flipped.id)
          << flipped.report << " and " << other.report;
    }
    for (size_t i = 1; i < flipped.states.size(); ++i) flipped.flip(look);
    EXPECT_EQ(flipped.get(look), before) << flipped.report;
  }
}

TEST(ViewSwitches, names_and_keys_are_unique) {
  std::set<std::string> shows, reports, labels;
  std::set<char> keys;
  for (const ViewSwitch& s : view_switches()) {
    EXPECT_TRUE(s.show[0] == '\0' || shows.insert(s.show).second) << s.show;
    EXPECT_TRUE(reports.insert(s.report).second) << s.report;
    EXPECT_TRUE(s.label[0] == '\0' || labels.insert(s.label).second) << s.label;
    EXPECT_TRUE(s.key == 0 || keys.insert(s.key).second) << s.key;
  }
}

TEST(ViewSwitches, user_facing_switches_have_a_label_and_a_tooltip) {
  for (const ViewSwitch& s : view_switches()) {
    const bool offered = s.in_view_panel || s.key != 0;
    EXPECT_EQ(offered, s.label[0] != '\0') << s.report;
    EXPECT_EQ(offered, s.tip[0] != '\0') << s.report;
  }
}

}  // namespace
}  // namespace kerf
