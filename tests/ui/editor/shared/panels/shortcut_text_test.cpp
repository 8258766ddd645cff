#include "ui/editor/shared/panel_rows.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(ShortcutText, names_the_key_that_an_action_has_at_the_moment) {
  ViewState view;
  view.shortcuts = {{"Hide the chosen", "Ctrl+H"}, {"Flip", ""}};
  EXPECT_EQ(with_shortcut(view, "Hides it.", "Hide the chosen"), "Hides it (Ctrl+H).");
  EXPECT_EQ(with_shortcut(view, "Hides it", "Hide the chosen"), "Hides it (Ctrl+H)");
  EXPECT_EQ(with_shortcut(view, "Turns it round.", "Flip"), "Turns it round.");
  EXPECT_EQ(with_shortcut(view, "Turns it round.", "no such action"), "Turns it round.");
  EXPECT_EQ(shortcut_of(view, "Hide the chosen"), "Ctrl+H");
}

}  // namespace
}  // namespace kerf
