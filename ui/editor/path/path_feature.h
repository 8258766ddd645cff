#pragma once

#include <functional>
#include <vector>

#include "core/document/stroke_path.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/path/path_tool.h"
#include "ui/window/number_text.h"

namespace kerf {

struct HolePattern {
  enum class Kind { kGrid, kCircle };
  Kind kind = Kind::kGrid;
  int rows = 3, columns = 4;   // of a grid, 1 .. kMaxInALine
  double spacing = 0.1;        // of neighbouring centres in a grid [m]
  int count = 8;               // on a circle, 1 .. kMaxInALine
  double circle_radius = 0.2;  // of the circle through the centres [m]
  double hole_radius = 0.03;   // [m]

  static constexpr int kMaxInALine = 100;
};

// Returns one stroke per hole. A beam of this radius [m] moves once along the inside of the hole and ends
// where it began; a hole no wider than the beam is a single key of a beam as wide as the hole. `beam` passes
// through the centre of the pattern. Rows are parallel to the world axis most nearly perpendicular to the
// beam, X before Z before Y. Times are those of 1 m/s. Precondition: all numbers are positive, and the
// direction is a result of beam_direction().
std::vector<StrokePath> hole_strokes(const HolePattern& pattern, const Pose& beam, double radius);

// The outline of a hole before it is added [m, world space]: a circle across the beam, at the depth of the
// first visible surface under its centre, else under a point of the circle, else of the beam's target.
struct HoleOutline {
  enum class Meets { kNothing, kInPart, kFully };
  std::vector<Vec3> points;
  Meets meets = Meets::kFully;  // how much of the circle and its centre has a visible surface under it
};
// Returns an outline per stroke of hole_strokes(). `distance` [m, > 0]: of the target from the origin of the
// beam. Samples fewer points of each circle if there are more than 100 holes. More than 400 are all at the
// depth of the target and count as full, for speed. Preconditions: those of hole_strokes().
std::vector<HoleOutline> hole_outlines(const HolePattern& pattern, const Pose& beam, double distance,
                                       const World& world, const ViewOptions& look);

// Rows of the Path panel that add a grid or circle of holes around the selected point.
class HoleForm {
 public:
  // `radius` [m]: of the beam. `speed` [m/s]: of a path that begins with the holes. Lengths default to
  // values from the size of the world until they are typed, and are reset in a world of a very different
  // size. Holes that meet no visible surface are left out.
  void draw(PathWork& path, const World& world, const ViewOptions& look, double radius, double speed,
            FileUnit unit);
  // Draws the outlines of the holes around the selected point if the rows were drawn in the last frame.
  void draw_preview(const PathWork& path, const World& world, const ViewState& view, ImDrawList& list);

 private:
  void draw_grid(FileUnit unit);
  void draw_circle(FileUnit unit);
  void fit_to(double diagonal);
  void add_holes(PathWork& path, const World& world, const std::vector<HoleOutline>& outlines, double radius,
                 double speed) const;

  HolePattern pattern_;
  NumberFields fields_;
  double fitted_to_ = 0;  // diagonal [m] that the lengths were set from
  bool drawn_ = false;    // in the last frame
};

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
  void draw_hole_preview(const PathWork& path, const World& world, const ViewState& view, ImDrawList& list) {
    holes_.draw_preview(path, world, view, list);
  }
  // Draw single rows. Precondition of the first: the path has points.
  void draw_speed(PathWork& path, FileUnit unit);
  void draw_resolution(bool& at_panel_resolution);

 private:
  void draw_buttons(PathWork& path, const ViewState& view, const char* run_disabled_reason,
                    const PathActions& requests);
  void draw_radius(PathWork& path, const World& world, FileUnit unit);
  void draw_beam(PathWork& path, bool& at_panel_resolution, const World& world, FileUnit unit);
  void draw_list(PathWork& path, const World& world, FileUnit unit);
  void draw_row(PathWork& path, PathPoint point, int number, double unit, double diagonal);
  void draw_selected(PathWork& path, const World& world, FileUnit unit);

  NumberFields fields_;
  HoleForm holes_;
  std::optional<PathPoint> shown_;  // point that the list was last scrolled to
};

}  // namespace kerf
