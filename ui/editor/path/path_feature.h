#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/files/mesh_format.h"
#include "ui/editor/path/hole_pattern.h"
#include "ui/editor/path/path_tool.h"
#include "ui/editor/shared/laser_controls.h"
#include "ui/window/number_text.h"

namespace kerf {

// The commands that run a path, and the message after they were executed.
struct PlannedRun {
  std::vector<Command> commands;
  std::string message;
};
// Returns the run of a path in a world with this diagonal [m], like kerf cut --path with the model, the power
// and the assist gas of the controls. `at_panel_resolution`: at the resolution of the controls, too.
// Precondition: each stroke has a key.
PlannedRun planned_run(std::span<const StrokePath> strokes, const LaserControls& laser, double diagonal,
                       bool at_panel_resolution);

// Actions of the panel that are not edits of the path.
struct PathActions {
  std::function<void()> run, load, save;
};

// Edits the path as numbers: speed and beam, points, the selected point, and patterns of holes.
class PathPanel {
 public:
  // `at_panel_resolution`: the path is run at the resolution of the Resolution panel, else like kerf cut
  // --path. `beam`: of new points. `run_disabled_reason`: the reason why the path cannot be run, or null.
  void draw(PathWork& path, bool& at_panel_resolution, const ViewState& view, const World& world,
            const PathTool::Beam& beam, const char* run_disabled_reason, const PathActions& requests);
  void draw_hole_preview(const ViewState& view, ImDrawList& list) { holes_.draw_preview(view, list); }
  // Draw single rows. Precondition of the first: the path has points.
  void draw_speed(PathWork& path, FileUnit unit);
  void draw_resolution(bool& at_panel_resolution);

 private:
  void draw_buttons(PathWork& path, const ViewState& view, const char* run_disabled_reason,
                    const PathActions& requests);
  const std::optional<PathPoint>& point_of_fields(const PathWork& path);
  void draw_radius(PathWork& path, size_t stroke, const World& world, FileUnit unit);
  void draw_beam(PathWork& path, bool& at_panel_resolution, const World& world, FileUnit unit);
  void draw_list(PathWork& path, const World& world, FileUnit unit);
  void draw_row(PathWork& path, PathPoint point, int number, double unit, double diagonal);
  void draw_selected(PathWork& path, const World& world, FileUnit unit);

  NumberFields fields_;
  HoleForm holes_;
  std::optional<PathPoint> shown_;   // point that the list was last scrolled to
  std::optional<PathPoint> edited_;  // point whose numbers are shown
};

}  // namespace kerf
