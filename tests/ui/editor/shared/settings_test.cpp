#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/base/json.h"
#include "ui/editor/shared/settings.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

class SettingsTest : public testing::Test {
 protected:
  SettingsTest() { fs::create_directories(folder); }
  ~SettingsTest() override { fs::remove_all(folder); }
  void put(const std::string& text) const { std::ofstream(file) << text; }
  std::string text() const {
    std::ostringstream all;
    all << std::ifstream(file).rdbuf();
    return all.str();
  }
  const fs::path folder =
      fs::path(testing::TempDir()) /
      (std::string("kerf-settings-") + testing::UnitTest::GetInstance()->current_test_info()->name());
  const fs::path file = folder / "settings.json";
};

TEST_F(SettingsTest, round_trip) {
  Settings settings;
  settings.theme = Theme::kLight;
  settings.ui_scale = 1.5;
  settings.palette = BoxPalette::kOrangeAndBlue;
  settings.panels["tree"] = true;
  settings.panels["laser"] = false;
  settings.tab = Tab::kThermal;
  settings.docks = {{"graph", Dock::kWindow}, {"tree", Dock::kColumn}};
  settings.windows["graph"] = {{20, 30}, {400, 300}};
  settings.second_ems = 15;
  settings.strip_ems = 12;
  settings.welcomed = true;
  settings.recent = {"/a/car.obj"};
  settings.pinned = {"/b/hood.obj", "/a/door.obj"};
  settings.folder = "/a";
  settings.drag_speed = 2;
  settings.wheel_speed = 0.5;
  settings.threads = 3;
  settings.autosave_seconds = 30;
  settings.bindings = {{"edit.undo", "Ctrl+U"}, {"view.wire", ""}};
  settings.frames["stl"] = FileFrame{FileUnit::kInch, UpAxis::kZ};
  settings.frames["obj"] = std::nullopt;
  ASSERT_TRUE(write_settings(settings, file).ok());
  const LoadedSettings loaded = read_settings(file);
  EXPECT_EQ(loaded.fault, "");
  EXPECT_EQ(loaded.settings, settings);
}

TEST_F(SettingsTest, default_without_a_file) {
  const LoadedSettings loaded = read_settings(folder / "none.json");
  EXPECT_EQ(loaded.fault, "");
  EXPECT_EQ(loaded.settings, Settings());
}

TEST_F(SettingsTest, unknown_keys_are_preserved) {
  put(R"({"version": 1, "theme": "light", "night_mode": {"deep": [1, 2]}})");
  LoadedSettings loaded = read_settings(file);
  EXPECT_EQ(loaded.settings.theme, Theme::kLight);
  loaded.settings.ui_scale = 2;
  ASSERT_TRUE(write_settings(loaded.settings, file).ok());
  EXPECT_EQ(nlohmann::json::parse(text())["night_mode"], nlohmann::json::parse(R"({"deep": [1, 2]})"));
}

TEST_F(SettingsTest, of_another_editor_are_kept_where_this_one_has_changed_nothing) {
  const Settings before;
  ASSERT_TRUE(write_settings(before, file).ok());
  Settings others = before, own = before;
  others.bindings = {{"edit.undo", "Ctrl+U"}};
  others.ui_scale = 1.5;
  others.threads = 1;
  own.threads = 3;
  ASSERT_TRUE(write_settings(others, file, &before).ok());
  ASSERT_TRUE(write_settings(own, file, &before).ok());
  const Settings read = read_settings(file).settings;
  EXPECT_EQ(read.bindings, others.bindings);
  EXPECT_EQ(read.ui_scale, 1.5);
  EXPECT_EQ(read.threads, 3);
}

TEST_F(SettingsTest, labels_of_version_1_are_converted_to_ids_once) {
  put(R"({"version": 1, "tab": "look",
          "bindings": {"Undo": "Ctrl+U", "Shadows: none, ground, all": "", "Tab: Move": "Q", "Not one": "R"},
          "panels": {"Scalar map": true, "Laser": false}, "docks": {"Graph": "window"},
          "windows": {"Graph": [20, 30, 400, 300]}})");
  const Settings settings = read_settings(file).settings;
  EXPECT_EQ(settings.tab, Tab::kView);
  EXPECT_EQ(settings.bindings,
            (std::map<std::string, std::string>{
                {"edit.undo", "Ctrl+U"}, {"view.shadows", ""}, {"tab.physics", "Q"}, {"Not one", "R"}}));
  EXPECT_EQ(settings.panels, (std::map<std::string, bool>{{"scalar_map", true}, {"laser", false}}));
  EXPECT_EQ(settings.docks, (std::map<std::string, Dock>{{"graph", Dock::kWindow}}));
  EXPECT_TRUE(settings.windows.contains("graph"));
  ASSERT_TRUE(write_settings(settings, file).ok());
  EXPECT_EQ(nlohmann::json::parse(text())["version"], 2);
  EXPECT_EQ(read_settings(file).settings, settings);
}

TEST_F(SettingsTest, a_broken_file_is_set_aside_and_reported) {
  put("{\"theme\": ");
  const LoadedSettings loaded = read_settings(file);
  EXPECT_EQ(loaded.settings, Settings());
  EXPECT_NE(loaded.fault.find("settings.json.bad"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "settings.json.bad"));
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(SettingsTest, invalid_values_become_defaults) {
  put(R"({"ui_scale": 900, "side_width": "wide", "recent": [7, "/b.obj"], "panels": [], "width": -4})");
  const Settings settings = read_settings(file).settings;
  EXPECT_EQ(settings.ui_scale, Settings::kMaxScale);
  EXPECT_EQ(settings.side_ems, Settings().side_ems);
  EXPECT_EQ(settings.recent, std::vector<fs::path>{"/b.obj"});
  EXPECT_EQ(settings.width, 0);
}

TEST(RecentFiles, are_the_ten_latest_without_duplicates) {
  Settings settings;
  for (int i = 0; i < 14; ++i) remember_recent(settings, "/none/" + std::to_string(i));
  remember_recent(settings, "/none/9");
  ASSERT_EQ(settings.recent.size(), Settings::kMaxRecent);
  EXPECT_EQ(settings.recent[0], "/none/9");
  EXPECT_EQ(settings.recent[1], "/none/13");
  EXPECT_EQ(std::count(settings.recent.begin(), settings.recent.end(), fs::path("/none/9")), 1);
}

TEST(RecentFiles, pinned_files_come_first_and_stay) {
  Settings settings;
  for (int i = 0; i < 4; ++i) remember_recent(settings, "/none/" + std::to_string(i));
  pin_recent(settings, "/none/1", true);
  pin_recent(settings, "/none/0", true);
  for (int i = 4; i < 20; ++i) remember_recent(settings, "/none/" + std::to_string(i));
  remember_recent(settings, "/none/0");
  const std::vector<fs::path> listed = listed_files(settings);
  ASSERT_EQ(listed.size(), 2 + Settings::kMaxRecent);
  EXPECT_EQ(std::vector(listed.begin(), listed.begin() + 3),
            (std::vector<fs::path>{"/none/1", "/none/0", "/none/19"}));
  pin_recent(settings, "/none/1", false);
  EXPECT_FALSE(is_pinned(settings, "/none/1"));
  EXPECT_EQ(settings.recent.front(), "/none/1");
  EXPECT_EQ(settings.recent.size(), Settings::kMaxRecent);
}

}  // namespace
}  // namespace kerf
