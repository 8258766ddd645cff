#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/files/mesh_format.h"
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

  static constexpr double kMinScale = 0.75, kMaxScale = 2;
  static constexpr double kMinSide = 13, kMaxSide = 42;
  static constexpr double kMinStrip = 8, kMaxStrip = 60;
  static constexpr double kMinSpeed = 0.25, kMaxSpeed = 4;
  static constexpr size_t kMaxRecent = 10;
  static constexpr int kMaxThreads = 64;
  static constexpr int kMinHistory = 16, kMaxHistory = 16384;

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

// Which panels are unfolded, and where: in the column at the right, behind the tab that they belong to, or in
// one of the other places that the settings know. Panels go by their titles; those of one title share all.
class PanelPlaces {
 public:
  // The settings must outlive it.
  explicit PanelPlaces(Settings& settings) : settings_(settings) {}

  // Tells of a panel. `dock` and `unfolded` are its first state, where the settings have none yet.
  void add(const std::string& title, Tab tab, Dock dock, bool unfolded);
  // To be called when all panels are told of: chooses the tab of the first one that is unfolded, where the
  // settings name no tab.
  void choose_tab();

  Tab tab() const { return settings_.tab.value_or(Tab::kCut); }
  void show_tab(Tab tab);

  // Preconditions of these: add() was called with the title.
  Tab tab_of(const std::string& title) const;
  Dock dock_of(const std::string& title) const;
  bool is_unfolded(const std::string& title) const;
  // Whether it is unfolded and neither hidden with the column nor behind another tab.
  bool shows(const std::string& title) const;
  // Unfolds it and brings it to the front.
  void show(const std::string& title);
  // Shows it, and scrolls it into view when it is drawn next.
  void reveal(const std::string& title);
  // Whether reveal() was called with it and the panel is not in view yet; once.
  bool take_revealed(const std::string& title);
  void fold(const std::string& title);
  // Shows it in another place.
  void dock(const std::string& title, Dock dock);
  // Whether any panel is unfolded there.
  bool has_any(Dock dock) const;

 private:
  Settings& settings_;
  std::string revealed_;  // the title, until it is drawn
  struct Known {
    std::string title;
    Tab tab;
  };
  std::vector<Known> known_;  // in the order in which they were told of
};

struct EditorOptions {
  // Scenes and meshes that are opened together. Those that cannot be read are left out with an error message;
  // if none can be read, the default scene is shown.
  std::vector<std::filesystem::path> files;
  std::optional<std::filesystem::path> report;  // JSON written at exit, also after SIGINT and SIGTERM
  // JSON of where the named parts of the window are, kept up frame by frame (see landmarks.h), for tests.
  std::optional<std::filesystem::path> landmarks;
  // A script of input that drives the editor without a screen (see event_script.h).
  std::optional<std::filesystem::path> events;
  bool own_font = false;      // ImGui's own font, as where none is installed
  int width = 0, height = 0;  // of the window, in screen coordinates; 0: as in the last session
  std::filesystem::path default_scene;
};

}  // namespace kerf
