#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "tests/support/checkout.h"
#include "ui/editor/actions.h"

namespace kerf {
namespace {

// "| Ctrl+O | Open... |" for every row of the sheet that F1 shows, in its order.
std::vector<std::string> rows_of_sheet() {
  std::vector<std::string> rows;
  for (const Gesture& g : gestures())
    rows.push_back(std::string("| ") + g.gesture + " | " + g.meaning + " |");
  for (const Action& a : actions()) {
    if (a.shortcut[0] != '\0') rows.push_back(std::string("| ") + a.shortcut + " | " + a.name + " |");
  }
  return rows;
}

std::vector<std::string> rows_of_readme() {
  std::ifstream readme(test::checkout() / "README.md");
  std::vector<std::string> rows;
  std::string line;
  while (std::getline(readme, line) && line != "| key or gesture | what it does |") {
  }
  std::getline(readme, line);  // the line under the head
  while (std::getline(readme, line) && line.starts_with("|")) rows.push_back(line);
  return rows;
}

TEST(Shortcuts, the_readme_lists_what_the_sheet_lists) { EXPECT_EQ(rows_of_readme(), rows_of_sheet()); }

TEST(Shortcuts, no_two_actions_share_a_key) {
  std::set<std::pair<int, int>> taken;
  for (const Action& a : actions()) {
    if (a.key == 0) continue;
    EXPECT_TRUE(taken.emplace(a.key, a.mods).second) << a.name;
  }
}

TEST(Shortcuts, what_is_written_in_the_menu_is_what_is_pressed) {
  for (const Action& a : actions()) EXPECT_EQ(a.shortcut[0] != '\0', a.key != 0) << a.name;
}

TEST(Actions, either_do_something_or_open_a_menu) {
  for (const Action& a : actions()) EXPECT_TRUE((a.run != nullptr) != (a.submenu != nullptr)) << a.name;
}

TEST(Shortcuts, every_action_of_a_menu_says_what_it_does) {
  for (const Action& a : actions()) {
    EXPECT_TRUE(a.submenu != nullptr || a.tip[0] != '\0') << a.name;
  }
}

}  // namespace
}  // namespace kerf
