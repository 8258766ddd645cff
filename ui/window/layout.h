#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/base/geometry.h"
#include "core/base/result.h"

namespace kerf {

// A rectangle of the window in screen coordinates, from its upper left corner.
struct Area {
  Vec2 at{0}, size{0};
  bool contains(Vec2 p) const {
    return p.x >= at.x && p.y >= at.y && p.x < at.x + size.x && p.y < at.y + size.y;
  }
  friend bool operator==(const Area&, const Area&) = default;
};

// The layout of the window: menu at the top, status bar at the bottom, panels at the right, at the left and
// below, and the viewport in the remaining area. In a small window the panels shrink, and disappear if
// their size would be unusable.
struct Layout {
  Area viewport, side, second_side, strip, status;
  // The halves of a split viewport; otherwise `first` is the whole viewport, and `second` has no width.
  Area first, second;
  double em = 16;  // text size, screen coordinates
  bool split() const { return second.size.x > 0; }
};

// The desired sizes of the panel areas [em]; 0: none.
struct PanelSizes {
  double side = 21, second_side = 0;  // widths at the right and at the left
  double strip = 0;                   // height below the viewport
};

// Computes the layout. `em` is the text size; `menu` and `status` are the heights of these bars.
Layout lay_out(Vec2 window, double em, double menu, double status, const PanelSizes& panels = {});

// Splits the viewport in two. `share` is the fraction of the width for the left half, limited so that both
// halves stay usable. Preconditions: the layout is not split, and the fraction is from 0 to 1.
Layout split_in_two(Layout whole, double share);

// The rectangles of named parts of the window, in screen coordinates. Tests that drive the window find
// parts by name, independent of font, theme and panel sizes.
//
// Landmarks belong to one frame. The file holds those of the last frame as JSON:
//   {"busy": false, "pointer": [x, y], "parts": {"NAME": [x, y, width, height]}}
class Landmarks {
 public:
  // finish() replaces `file` atomically; its folder must exist. Without a file, the landmarks are only
  // available by text().
  explicit Landmarks(std::optional<std::filesystem::path> file) : file_(std::move(file)) {}

  void begin_frame() { areas_.clear(); }
  // Sets a prefix of the names that follow, for widgets that are also elsewhere in the window.
  void set_prefix(std::string prefix) { prefix_ = std::move(prefix); }
  // Records a landmark; the last one of a name in a frame counts.
  void mark(const std::string& name, const Area& area) { areas_.insert_or_assign(prefix_ + name, area); }
  // Records the areas of the layout under the names of the members of Layout.
  void mark(const Layout& layout);
  // Returns the area of a part in this frame; nullopt if it was not drawn.
  std::optional<Area> find(const std::string& name) const;
  // Ends the frame and writes its landmarks if they differ from the file. `busy`: more frames follow without
  // further input. `pointer`: its position in this frame; once a test reads the last position that it sent,
  // all earlier input was processed. On failure the file is unchanged.
  Status finish(bool busy, Vec2 pointer);
  // The content of the file after finish(), in one line.
  std::string text() const;

 private:
  std::optional<std::filesystem::path> file_;
  std::map<std::string, Area> areas_;
  std::string prefix_;
  bool busy_ = false;
  Vec2 pointer_{0};
  std::string written_;  // content of the file
};

// Makes the landmarks available to widgets through the current ImGui context; nullptr: none. They must
// outlive the drawn frames.
void keep_landmarks(Landmarks* landmarks);
// Sets the prefix of the names that follow (see Landmarks::set_prefix).
void prefix_landmarks(const char* prefix);
// Records the last widget as a landmark. No cost without landmarks.
void mark_last_item(const char* name, int number);
void mark_last_item(const char* name);
// Records an area that is not a widget.
void mark_area(const char* name, const Area& area);
// Records the current window or popup.
void mark_window(const char* name);

}  // namespace kerf
