#pragma once

#include <functional>

#include "ui/editor/path/hole_form.h"
#include "ui/editor/path/path_tool.h"

namespace kerf {

// What the panel asks for beside edits of the path.
struct PathWishes {
  std::function<void()> run, load, save;
};

// The path as numbers: its speed and beam, its points, the chosen point, and holes in a pattern.
class PathPanel {
 public:
  // `at_panel_resolution`: the path is run so, and not as kerf cut --path does. `beam` is what a new point
  // gets. `why_no_run` is the reason why the path cannot be run, or null.
  void draw(PathWork& path, bool& at_panel_resolution, const ViewState& view, const World& world,
            const PathTool::Beam& beam, const char* why_no_run, const PathWishes& wishes);

 private:
  void draw_buttons(PathWork& path, const ViewState& view, const char* why_no_run, const PathWishes& wishes);
  void draw_speed(PathWork& path, FileUnit unit);
  void draw_radius(PathWork& path, const World& world, FileUnit unit);
  void draw_beam(PathWork& path, bool& at_panel_resolution, const World& world, FileUnit unit);
  void draw_list(PathWork& path, const World& world, FileUnit unit);
  void draw_row(PathWork& path, PathPoint point, int number, double unit, double diagonal);
  void draw_chosen(PathWork& path, const World& world, FileUnit unit);

  NumberFields fields_;
  HoleForm holes_;
  std::optional<PathPoint> shown_;  // the point to which the list was scrolled last
};

}  // namespace kerf
