#pragma once

#include <functional>
#include <vector>

#include "core/document/stroke_path.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/path/path_tool.h"
#include "ui/editor/path/path_work.h"
#include "ui/window/number_fields.h"

namespace kerf {

// Holes in a grid or on a circle, all drilled in one direction.
struct HolePattern {
  enum class Kind { kGrid, kCircle };
  Kind kind = Kind::kGrid;
  int rows = 3, columns = 4;   // of a grid, 1 .. kMaxInALine
  double spacing = 0.1;        // m, between the middles of neighbours in a grid
  int count = 8;               // on a circle, 1 .. kMaxInALine
  double circle_radius = 0.2;  // m, of the circle on which the middles lie
  double hole_radius = 0.03;   // m

  static constexpr int kMaxInALine = 100;
};

// The strokes that drill the holes, one for each: the beam, of this radius (m), goes once round along the
// inside of the hole and ends where it began. A hole that is no wider than the beam is one key of a beam as
// wide as the hole. `beam` is in the middle of the pattern. The rows of a grid lie along the axis of the
// world that is most nearly across the beam, X before Z before Y. The times are those of 1 m/s. Precondition:
// all numbers are positive, and the direction is one of beam_direction().
std::vector<StrokePath> hole_strokes(const HolePattern& pattern, const Pose& beam, double radius);

// The rows of the Path panel that make a grid or a circle of holes around the chosen point of the path.
class HoleForm {
 public:
  // `radius` (m) is that of the beam, `speed` (m/s) that of a path that begins with the holes. The lengths
  // follow from the size of the world until they are typed; a world of quite another size sets them anew.
  void draw(PathWork& path, const World& world, double radius, double speed, FileUnit unit);

 private:
  void draw_grid(FileUnit unit);
  void draw_circle(FileUnit unit);
  void fit_to(double diagonal);
  void add_holes(PathWork& path, const World& world, double radius, double speed) const;

  HolePattern pattern_;
  NumberFields fields_;
  double fitted_to_ = 0;  // the diagonal from which the lengths were set
};

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
