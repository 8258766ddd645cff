#include "core/base/platform.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>

namespace kerf {
namespace {

class UserFolders : public testing::Test {
 protected:
  UserFolders() {
    for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"}) {
      if (const char* value = std::getenv(name)) before_[name] = value;
      unsetenv(name);
    }
  }
  ~UserFolders() override {
    for (const auto& [name, value] : before_) set(name.c_str(), value.c_str());
  }
  static void set(const char* name, const char* value) { setenv(name, value, 1); }

 private:
  std::map<std::string, std::string> before_;
};

TEST_F(UserFolders, follow_the_xdg_variables) {
  set("HOME", "/home/someone");
  set("XDG_CONFIG_HOME", "/settings");
  set("XDG_STATE_HOME", "/state");
  EXPECT_EQ(settings_folder(), "/settings/kerf");
  EXPECT_EQ(state_folder(), "/state/kerf");
}

TEST_F(UserFolders, fall_back_to_home_unless_a_variable_is_an_absolute_path) {
  set("HOME", "/home/someone");
  set("XDG_CONFIG_HOME", "settings");
  EXPECT_EQ(settings_folder(), "/home/someone/.config/kerf");
  EXPECT_EQ(state_folder(), "/home/someone/.local/state/kerf");
}

TEST_F(UserFolders, fall_back_to_the_root_without_a_home) {
  EXPECT_EQ(settings_folder(), "/.config/kerf");
  EXPECT_TRUE(home_folder().empty());
}

}  // namespace
}  // namespace kerf
