#include "ui/editor/shell/settings_page.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/editor_features.h"

namespace kerf {
namespace {

using Page = SettingsPage::Page;

struct Bench {
  Bench() { toggle_settings_page(page); }
  void press(int key, int mods = 0) { settings_page_key(page, settings, editor.catalogue.usual, key, mods); }
  void search(const char* text) { std::strcpy(page.query.data(), text); }

  test::EditorFeatures editor;
  Settings settings;
  SettingsPage page;
};

TEST(SettingsPageKeys, turn_pages_and_change_values) {
  Bench bench;
  EXPECT_TRUE(bench.page.shown && bench.page.take_focus);
  bench.press(GLFW_KEY_RIGHT);
  EXPECT_EQ(bench.settings.theme, Theme::kLight);
  bench.press(GLFW_KEY_DOWN);
  bench.press(GLFW_KEY_RIGHT);
  EXPECT_EQ(bench.settings.ui_scale, 1.125);
  for (int i = 0; i < 40; ++i) bench.press(GLFW_KEY_LEFT);
  EXPECT_EQ(bench.settings.ui_scale, Settings::kMinScale);
  bench.press(GLFW_KEY_PAGE_UP);
  EXPECT_EQ(bench.page.page, Page::kAppearance);
  for (int i = 0; i < 9; ++i) bench.press(GLFW_KEY_PAGE_DOWN);
  EXPECT_EQ(bench.page.page, Page::kFiles);
}

TEST(SettingsPageKeys, a_letter_returns_to_the_search) {
  Bench bench;
  bench.page.take_focus = false;
  bench.press(GLFW_KEY_DOWN);
  EXPECT_FALSE(bench.page.take_focus);
  bench.press(GLFW_KEY_Z, GLFW_MOD_CONTROL);
  EXPECT_FALSE(bench.page.take_focus);
  bench.press(GLFW_KEY_Z);
  EXPECT_TRUE(bench.page.take_focus);
}

TEST(SettingsPageKeys, a_search_reaches_the_rows_of_all_pages) {
  Bench bench;
  for (const char* words : {"autosave", "EDIT minimum time"}) {
    bench.settings = Settings();
    bench.search(words);
    bench.press(GLFW_KEY_RIGHT);
    EXPECT_EQ(bench.settings.autosave_seconds, 5) << words;
  }
  for (int i = 0; i < 9; ++i) bench.press(GLFW_KEY_RIGHT);
  EXPECT_EQ(bench.settings.autosave_seconds, 300);
  bench.search("stl no such row");
  bench.press(GLFW_KEY_RIGHT);
  EXPECT_TRUE(bench.settings.frames.empty());
  bench.search("stl length");
  bench.press(GLFW_KEY_RIGHT);
  ASSERT_TRUE(bench.settings.frames.contains("stl"));
  EXPECT_FALSE(bench.settings.frames["stl"]);
  bench.press(GLFW_KEY_RIGHT);
  EXPECT_EQ(bench.settings.frames["stl"]->unit, FileUnit::kMillimetre);
  bench.press(GLFW_KEY_ESCAPE);
  EXPECT_TRUE(bench.page.shown && bench.page.query.front() == '\0');
  bench.press(GLFW_KEY_ESCAPE);
  EXPECT_FALSE(bench.page.shown);
}

TEST(SettingsPageKeys, rebind_and_clear_an_action_found_by_its_name) {
  Bench bench;
  bench.search("wireframe");
  bench.press(GLFW_KEY_ENTER);
  ASSERT_EQ(bench.page.waits_for, "view.wire");
  bench.press(GLFW_KEY_F7);
  EXPECT_EQ(bench.settings.bindings, (std::map<std::string, std::string>{{"view.wire", "F7"}}));
  bench.press(GLFW_KEY_DELETE);
  EXPECT_EQ(bench.settings.bindings.at("view.wire"), "");
}

TEST(SettingsPageKeys, that_edit_text_belong_to_the_search_until_the_cursor_leaves_it) {
  Bench bench;
  bench.page.in_search = true;
  bench.search("wireframe");
  bench.press(GLFW_KEY_DELETE);
  bench.press(GLFW_KEY_LEFT);
  bench.press(GLFW_KEY_RIGHT);
  EXPECT_EQ(bench.settings, Settings());
  bench.press(GLFW_KEY_ENTER);
  EXPECT_TRUE(bench.page.leaves_search && bench.page.waits_for.empty());
  bench.page.in_search = bench.page.take_focus = false;
  bench.press(GLFW_KEY_UP);
  EXPECT_TRUE(bench.page.take_focus);
}

}  // namespace
}  // namespace kerf
