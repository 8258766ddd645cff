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

// Tasks of the user; each is a tab of the sidebar.
enum class Tab { kCut, kView, kPhysics, kThermal, kMesh };
// The place of a panel: behind its tab in the sidebar (right), in a second column (left), in a strip below
// the viewport, or in a floating window.
enum class Dock { kColumn, kSecondColumn, kStrip, kWindow };

struct Settings {
  Theme theme = Theme::kDark;
  double ui_scale = 1;  // relative to the scale of the display
  bool side_shown = true;
  bool toolbar_shown = true;  // the tools at the edge of the viewport
  double side_ems = 21;       // width of the sidebar, sizes of the text
  double second_ems = 21;     // width of the second column, likewise
  double strip_ems = 22;      // height of the strip, likewise
  int width = 0, height = 0;  // of the window, screen coordinates; 0: none yet (see WindowOptions)
  BoxPalette palette = BoxPalette::kRedAndGreen;
  bool antialias = true;
  double split_share = 0.5;                // share of the left half in the width of a split view
  int history_megabytes = 1024;            // of undo data
  int autosave_seconds = 0;                // least time between two autosaves; 0: every change
  int threads = 0;                         // limit for loading, measuring and saving; 0: all of the machine
  bool live_recut = true;                  // resolution sliders recut the last stroke
  bool prepare_preview = true;             // mesh tools show a preview
  bool heat_held = false;                  // temperatures stay constant while the simulation is paused
  double drag_speed = 1, wheel_speed = 1;  // of the mouse, relative to the default
  std::map<std::string, std::string> bindings;  // chords by id of action, if not the default
  std::optional<Tab> tab;                       // nullopt: that of the first unfolded panel
  std::map<std::string, bool> panels;           // whether they are unfolded, by their ids
  std::map<std::string, Dock> docks;            // by their ids; not in here: in the sidebar
  std::map<std::string, Area> windows;          // last areas of floating panels, by their ids
  std::vector<std::filesystem::path> recent;    // latest first, absolute, without the pinned ones
  std::vector<std::filesystem::path> pinned;    // recent files that stay, in the order of pinning
  // Frames by mesh format ("stl"); nullopt: a guess for each file. Missing formats were not asked about yet.
  std::map<std::string, std::optional<FileFrame>> frames;
  std::filesystem::path folder;  // last folder of the file browser
  bool welcomed = false;         // the welcome was shown
  std::string others = "{}";     // JSON: unknown keys of the file

  static constexpr double kMinScale = 0.75, kMaxScale = 2;
  static constexpr double kMinSide = 13, kMaxSide = 42;
  static constexpr double kMinStrip = 8, kMaxStrip = 60;
  static constexpr double kMinSpeed = 0.25, kMaxSpeed = 4;
  static constexpr size_t kMaxRecent = 10;
  static constexpr int kMaxThreads = 64;
  static constexpr int kMinHistory = 16, kMaxHistory = 16384;
  static constexpr int kMaxAutosave = 3600;

  size_t history_bytes() const { return static_cast<size_t>(history_megabytes) << 20; }

  friend bool operator==(const Settings&, const Settings&) = default;
};

// Converts a frame to {"unit": "mm", "up": "z"}, and back; nullopt if invalid.
nlohmann::json frame_to_json(const FileFrame& frame);
std::optional<FileFrame> frame_from_json(const nlohmann::json& json);

// Returns the path of a recent file: absolute, with symbolic links resolved where possible.
std::filesystem::path whole_path(const std::filesystem::path& file);
// Moves a file to the front of the recent files, unless it is pinned.
void remember_recent(Settings& settings, const std::filesystem::path& file);
// Pins or unpins a recent file. Unpinned, it becomes the latest one.
void pin_recent(Settings& settings, const std::filesystem::path& file, bool pinned);
bool is_pinned(const Settings& settings, const std::filesystem::path& file);
// Returns the pinned files and then the recent ones.
std::vector<std::filesystem::path> listed_files(const Settings& settings);

// Returns the settings file, below settings_folder().
std::filesystem::path settings_file();

struct LoadedSettings {
  Settings settings;
  std::string fault;  // one sentence, or empty
};

// Reads the settings. A missing file and invalid values give defaults. Labels in a file of version 1 become
// ids. A file that cannot be read or is not JSON is renamed with ".bad" appended, so that it is not
// overwritten.
LoadedSettings read_settings(const std::filesystem::path& file);

// Writes the settings atomically, and creates missing folders. Entries that are equal in `before`, the
// settings last read or written by this editor, keep the values that another editor has written since; with
// null, all entries are written.
Status write_settings(const Settings& settings, const std::filesystem::path& file,
                      const Settings* before = nullptr);

// The state of the panels: unfolded or not, and their places, in the sidebar or docked elsewhere. Panels are
// identified by their ids.
class PanelPlaces {
 public:
  // The settings must outlive it.
  explicit PanelPlaces(Settings& settings) : settings_(settings) {}

  // Registers a panel. `dock` and `unfolded` apply if the settings have no state for it.
  void add(const std::string& id, Tab tab, Dock dock, bool unfolded);
  // Called after all add(): selects the tab of the first unfolded panel if the settings name none.
  void select_tab();

  Tab tab() const { return settings_.tab.value_or(Tab::kCut); }
  void show_tab(Tab tab);

  // Precondition of the following: add() was called with the id.
  Tab tab_of(const std::string& id) const;
  Dock dock_of(const std::string& id) const;
  bool is_unfolded(const std::string& id) const;
  // Returns true if it is unfolded and neither hidden with the sidebar nor behind another tab.
  bool shows(const std::string& id) const;
  // Unfolds it and brings it to the front.
  void show(const std::string& id);
  // Shows it, and scrolls it into view when it is next drawn.
  void reveal(const std::string& id);
  // Returns true, once, if reveal() was called with it and the panel is not in view yet.
  bool take_revealed(const std::string& id);
  void fold(const std::string& id);
  void dock(const std::string& id, Dock dock);
  bool has_any(Dock dock) const;

 private:
  Settings& settings_;
  std::string revealed_;  // the id, until it is drawn
  struct Known {
    std::string id;
    Tab tab;
  };
  std::vector<Known> known_;  // in the order of registration
};

struct EditorOptions {
  // Scenes and meshes to open together. Unreadable ones are left out with an error; if none can be read, the
  // default scene is shown.
  std::vector<std::filesystem::path> files;
  std::optional<std::filesystem::path> report;  // JSON written at exit, also after SIGINT and SIGTERM
  // JSON with the landmarks of the window, updated frame by frame, for tests.
  std::optional<std::filesystem::path> landmarks;
  // A script of input that drives the editor without a screen.
  std::optional<std::filesystem::path> events;
  bool own_font = false;      // ImGui's built-in font, as if none were installed
  int width = 0, height = 0;  // of the window, in screen coordinates; 0: as in the last session
  std::filesystem::path default_scene;
  std::string version;  // of the program, with its commit
};

}  // namespace kerf
