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
// below, and the picture in the remaining area. In a small window the panels shrink, and disappear if they
// would have no usable size.
struct Layout {
  Area viewport, side, second_side, strip, status;
  // The halves of the viewport if it is split; otherwise `first` is all of it, and `second` has no width.
  Area first, second;
  double em = 16;  // the size of the text
  bool split() const { return second.size.x > 0; }
};

// The desired sizes of the areas of panels, in sizes of the text; 0: none.
struct PanelSizes {
  double side = 21, second_side = 0;  // widths at the right and at the left
  double strip = 0;                   // height below the picture
};

// Computes the layout. `em` is the size of the text, `menu` and `status` are the heights of these bars.
Layout lay_out(Vec2 window, double em, double menu, double status, const PanelSizes& panels = {});

// Splits the viewport in two. The left half takes this fraction of its width, limited so that both halves
// stay usable. Preconditions: it is whole, and the fraction is from 0 to 1.
Layout split_in_two(Layout whole, double share);

// The rectangles of named parts of the window, in screen coordinates, for tests that drive the window from
// outside: they find a part by its name, whatever the font, the theme and the sizes of the panels are.
//
// A landmark belongs to one frame. The file holds those of the last frame as JSON:
//   {"busy": false, "pointer": [x, y], "parts": {"NAME": [x, y, width, height]}}
class Landmarks {
 public:
  // `file` is replaced atomically by finish(); its folder must exist. Without one only text() tells of them.
  explicit Landmarks(std::optional<std::filesystem::path> file) : file_(std::move(file)) {}

  // Forgets the landmarks of the last frame.
  void begin_frame() { areas_.clear(); }
  // The last mark of a name in a frame counts.
  void mark(std::string name, const Area& area) { areas_.insert_or_assign(std::move(name), area); }
  // The areas of the layout, under the names of the members of Layout.
  void mark(const Layout& layout);
  // Where a part is in this frame; nothing where it was not drawn.
  std::optional<Area> find(const std::string& name) const;
  // Ends the frame and writes its landmarks where they differ from those in the file. `busy`: more frames
  // follow without further input. `pointer`: where this frame saw the pointer; a test that finds it where it
  // last moved it knows that all input up to then was heard. On failure the file is as it was.
  Status finish(bool busy, Vec2 pointer);
  // What the file holds after finish(), in one line.
  std::string text() const;

 private:
  std::optional<std::filesystem::path> file_;
  std::map<std::string, Area> areas_;
  bool busy_ = false;
  Vec2 pointer_{0};
  std::string written_;  // what the file holds
};

// The current ImGui context hands the landmarks to the widgets; nullptr: none are kept. They must outlive the
// frames that are drawn.
void keep_landmarks(Landmarks* landmarks);
// Marks the widget that was drawn last. Costs nothing where no landmarks are kept.
void mark_last_item(const char* name, int number);
void mark_last_item(const char* name);
// Marks something that is not a widget.
void mark_area(const char* name, const Area& area);
// Marks the window or popup that is being drawn.
void mark_window(const char* name);

}  // namespace kerf
