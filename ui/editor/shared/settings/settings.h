#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/files/file_frame.h"
#include "ui/render/view/view_options.h"
#include "ui/window/gui_look.h"
#include "ui/window/layout.h"

namespace kerf {

// What one does while one looks at a panel; each is a tab of the column of panels.
enum class Tab { kCut, kLook, kMove, kHeat, kPrepare };
// Where a panel is drawn: behind its tab in the column at the right, in a second column at the left, in a
// strip below the picture, or in a window of its own over it.
enum class Dock { kColumn, kSecondColumn, kStrip, kWindow };

// Settings that the editor keeps between sessions.
struct Settings {
  Theme theme = Theme::kDark;
  double ui_scale = 1;  // relative to the scale of the display
  bool side_shown = true;
  double side_ems = 21;            // width of the column of panels, in sizes of the text
  double second_ems = 21;          // width of the second column
  double strip_ems = 22;           // height of the strip
  int width = 1280, height = 800;  // of the window, screen coordinates
  BoxPalette palette = BoxPalette::kRedAndGreen;
  bool antialias = true;
  double split_share = 0.5;                // fraction of the width for the left half of a split picture
  int history_megabytes = 1024;            // of undo data
  int threads = 0;                         // that load, measure and save at most; 0: as many as there are
  bool live_recut = true;                  // sliders of the resolution cut the last stroke again
  bool prepare_preview = true;             // the Prepare panel shows what its tool would make
  bool heat_held = false;                  // what is hot stays as it is while the user does not play
  double drag_speed = 1, wheel_speed = 1;  // of orbits and zooms by the mouse, relative to the usual speed
  std::map<std::string, std::string> bindings;  // keys by the names of actions, where they are not the usual
  std::optional<Tab> tab;                       // none: that of the first panel that is unfolded
  std::map<std::string, bool> panels;           // whether they are unfolded, by their titles
  std::map<std::string, Dock> docks;            // where they are, by their titles; not here: in the column
  std::map<std::string, Area> windows;          // where windows of panels were last, by their titles
  std::vector<std::filesystem::path> recent;    // latest first, absolute
  // How mesh files of a kind ("stl") are shown; none where the user wants a guess for each file. Kinds that
  // are not here were not asked about yet.
  std::map<std::string, std::optional<FileFrame>> frames;
  std::filesystem::path folder;  // the folder that the file browser showed last
  bool welcomed = false;         // the welcome was shown
  std::string others = "{}";     // JSON: keys of the file that this version does not know

  static constexpr double kLeastScale = 0.75, kMostScale = 2;
  static constexpr double kLeastSide = 13, kMostSide = 42;
  static constexpr double kLeastStrip = 8, kMostStrip = 60;
  static constexpr double kLeastSpeed = 0.25, kMostSpeed = 4;
  static constexpr size_t kMostRecent = 10;
  static constexpr int kMostThreads = 64;
  static constexpr int kLeastHistory = 16, kMostHistory = 16384;

  size_t history_bytes() const { return static_cast<size_t>(history_megabytes) << 20; }

  friend bool operator==(const Settings&, const Settings&) = default;
};

// A frame as {"unit": "mm", "up": "z"}, and back; nothing where it is not one.
nlohmann::json frame_to_json(const FileFrame& frame);
std::optional<FileFrame> frame_from_json(const nlohmann::json& json);

// The path of a file by which it is a recent file: absolute, without symbolic links where they can be
// followed.
std::filesystem::path whole_path(const std::filesystem::path& file);
// Moves a file to the front of the recent files.
void remember_recent(Settings& settings, const std::filesystem::path& file);

// The file of the settings, below settings_folder().
std::filesystem::path settings_file();

struct LoadedSettings {
  Settings settings;
  std::string fault;  // one sentence, or empty
};

// Reads the settings. A missing file and invalid values give defaults. A file that is not JSON is renamed
// with ".bad" appended, so that it is not lost when the settings are written.
LoadedSettings read_settings(const std::filesystem::path& file);

// Writes the settings, whole or not at all, and creates missing folders.
Status write_settings(const Settings& settings, const std::filesystem::path& file);

}  // namespace kerf
