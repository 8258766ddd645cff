#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ui/editor/camera_text.h"
#include "ui/editor/file_browser.h"
#include "ui/editor/number_text.h"
#include "ui/editor/settings.h"

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

TEST_F(SettingsTest, come_back_as_they_were_written) {
  Settings settings;
  settings.theme = Theme::kLight;
  settings.ui_scale = 1.5;
  settings.palette = BoxPalette::kOrangeAndBlue;
  settings.panels = {{"Tree", true}, {"Laser", false}};
  settings.recent = {"/a/car.obj"};
  settings.folder = "/a";
  ASSERT_TRUE(write_settings(settings, file).ok());
  const LoadedSettings loaded = read_settings(file);
  EXPECT_EQ(loaded.fault, "");
  EXPECT_EQ(loaded.settings, settings);
}

TEST_F(SettingsTest, none_are_the_defaults) {
  const LoadedSettings loaded = read_settings(folder / "none.json");
  EXPECT_EQ(loaded.fault, "");
  EXPECT_EQ(loaded.settings, Settings());
}

TEST_F(SettingsTest, keys_of_a_later_version_are_kept) {
  put(R"({"version": 1, "theme": "light", "night_mode": {"deep": [1, 2]}})");
  LoadedSettings loaded = read_settings(file);
  EXPECT_EQ(loaded.settings.theme, Theme::kLight);
  loaded.settings.ui_scale = 2;
  ASSERT_TRUE(write_settings(loaded.settings, file).ok());
  EXPECT_EQ(nlohmann::json::parse(text())["night_mode"], nlohmann::json::parse(R"({"deep": [1, 2]})"));
}

TEST_F(SettingsTest, a_broken_file_is_set_aside_and_said) {
  put("{\"theme\": ");
  const LoadedSettings loaded = read_settings(file);
  EXPECT_EQ(loaded.settings, Settings());
  EXPECT_NE(loaded.fault.find("settings.json.bad"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "settings.json.bad"));
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(SettingsTest, values_without_sense_are_the_defaults) {
  put(R"({"ui_scale": 900, "side_width": "wide", "recent": [7, "/b.obj"], "panels": [], "width": -4})");
  const Settings settings = read_settings(file).settings;
  EXPECT_EQ(settings.ui_scale, Settings::kMostScale);
  EXPECT_EQ(settings.side_ems, Settings().side_ems);
  EXPECT_EQ(settings.recent, std::vector<fs::path>{"/b.obj"});
  EXPECT_GE(settings.width, 480);
}

TEST(RecentFiles, are_ten_without_doubles_the_latest_first) {
  Settings settings;
  for (int i = 0; i < 14; ++i) remember_recent(settings, "/none/" + std::to_string(i));
  remember_recent(settings, "/none/9");
  ASSERT_EQ(settings.recent.size(), Settings::kMostRecent);
  EXPECT_EQ(settings.recent[0], "/none/9");
  EXPECT_EQ(settings.recent[1], "/none/13");
  EXPECT_EQ(std::count(settings.recent.begin(), settings.recent.end(), fs::path("/none/9")), 1);
}

TEST_F(SettingsTest, the_browser_lists_folders_and_what_can_be_opened) {
  fs::create_directories(folder / "Zoo");
  fs::create_directories(folder / ".hidden");
  for (const char* name : {"b.OBJ", "a.stl", "note.txt", "scene.json", ".secret.obj"})
    std::ofstream(folder / name);
  std::string fault;
  std::vector<std::string> names;
  for (const auto& entry : list_folder(folder, fault)) names.push_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Zoo", "a.stl", "b.OBJ", "scene.json"}));
  EXPECT_EQ(fault, "");
  EXPECT_TRUE(list_folder(folder / "none", fault).empty());
  EXPECT_NE(fault, "");
  EXPECT_TRUE(passes_filter("Car-Cut.OBJ", "cut.o"));
  EXPECT_FALSE(passes_filter("car.obj", "stl"));
}

TEST(CameraText, comes_back_as_it_was_copied) {
  const View view{{1.0 / 3, 2, -3e-7}, {0, 0.5, 0}};
  const auto parsed = parse_view_text(view_text(view));
  ASSERT_TRUE(parsed.ok());
  EXPECT_EQ(parsed->eye, view.eye);
  EXPECT_EQ(parsed->target, view.target);
}

TEST(CameraText, takes_a_scene_and_refuses_what_is_no_view) {
  EXPECT_TRUE(parse_view_text(R"({"view": {"eye": [1,2,3], "target": [0,0,0]}})").ok());
  for (const char* text : {"", "hello", "{}", "[1]", R"({"eye": [1,2], "target": [0,0,0]})",
                           R"({"eye": [1,2,3], "target": [1,2,3]})"}) {
    EXPECT_FALSE(parse_view_text(text).ok()) << text;
  }
}

TEST(NumberText, groups_digits_and_chooses_the_unit_of_area) {
  EXPECT_EQ(grouped(12345678), "12 345 678");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(area_text(6.27), "6.27 m\xc2\xb2");
  EXPECT_EQ(area_text(0.00041), "4.1 cm\xc2\xb2");
}

}  // namespace
}  // namespace kerf
