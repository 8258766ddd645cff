#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/render/view_options.h"
#include "ui/window/gui_look.h"

namespace kerf {

// The groups of the column of panels, from top to bottom.
enum class PanelId {
  kLaser,
  kResolution,
  kPieces,
  kHistory,
  kLight,
  kTree,
  kView,
  kStatistics,
  kFile,
  kDisplay
};

// What the editor remembers from one time to the next.
struct Settings {
  Theme theme = Theme::kDark;
  double ui_scale = 1;  // on top of what the display asks for
  bool side_shown = true;
  double side_ems = 21;            // width of the column of panels, in sizes of the text
  int width = 1280, height = 800;  // of the window, screen coordinates
  BoxPalette palette = BoxPalette::kRedAndGreen;
  bool antialias = true;
  double split_share = 0.5;      // of the picture's width that the left half of a split one takes
  int history_megabytes = 1024;  // of before-images
  bool live_recut = true;        // the resolution's sliders cut the last stroke again
  std::map<PanelId, bool> panels = panels_at_first();  // which are unfolded
  std::vector<std::filesystem::path> recent;           // latest first, absolute
  std::filesystem::path folder;                        // where the file browser was last
  std::string others = "{}";  // JSON: keys of the file that this version does not know

  static constexpr double kLeastScale = 0.75, kMostScale = 2;
  static constexpr double kLeastSide = 13, kMostSide = 42;
  static constexpr size_t kMostRecent = 10;
  static constexpr int kLeastHistory = 16, kMostHistory = 16384;
  static std::map<PanelId, bool> panels_at_first();

  size_t history_bytes() const { return static_cast<size_t>(history_megabytes) << 20; }

  // Whether a panel is seen unfolded, with the column.
  bool shows(PanelId panel) const { return side_shown && panels.at(panel); }
  friend bool operator==(const Settings&, const Settings&) = default;
};

// Puts a file first among the recent ones.
void remember_recent(Settings& settings, const std::filesystem::path& file);

// kerf/settings.json under $XDG_CONFIG_HOME, or ~/.config where that is not set.
std::filesystem::path settings_file();

struct LoadedSettings {
  Settings settings;
  std::string fault;  // one sentence, or empty
};

// A file that is not there gives the defaults, and so does a value that makes no sense. What is not JSON at
// all is set aside with ".bad" added to its name, so that nothing is lost when the settings are written
// again.
LoadedSettings read_settings(const std::filesystem::path& file);

// Makes the folders that are missing. Whole or not at all.
Status write_settings(const Settings& settings, const std::filesystem::path& file);

}  // namespace kerf
