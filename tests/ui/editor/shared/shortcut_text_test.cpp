#include "ui/editor/shared/panel_rows.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(ShortcutText, names_the_current_key_of_an_action) {
  ViewState view;
  view.shortcuts = {{"pieces.hide", "Ctrl+H"}, {"section.flip", ""}};
  EXPECT_EQ(with_shortcut(view, "Hides it.", "pieces.hide"), "Hides it (Ctrl+H).");
  EXPECT_EQ(with_shortcut(view, "Hides it", "pieces.hide"), "Hides it (Ctrl+H)");
  EXPECT_EQ(with_shortcut(view, "Turns it round.", "section.flip"), "Turns it round.");
  EXPECT_EQ(with_shortcut(view, "Turns it round.", "no such action"), "Turns it round.");
  EXPECT_EQ(shortcut_of(view, "pieces.hide"), "Ctrl+H");
}

}  // namespace
}  // namespace kerf
