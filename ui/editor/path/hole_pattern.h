#pragma once

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
// Returns an outline per stroke of hole_strokes(). `distance` [m, >= 0]: of the target from the origin of the
// beam. Samples fewer points of each circle if there are more than 100 holes. More than 400 are all at the
// depth of the target and count as full, for speed. In the exploded view, surfaces count where they are cut.
// Preconditions: those of hole_strokes().
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
  void draw_preview(const ViewState& view, ImDrawList& list);

 private:
  void draw_grid(FileUnit unit);
  void draw_circle(FileUnit unit);
  void fit_to(double diagonal);
  void add_holes(PathWork& path, const World& world, double radius, double speed) const;

  HolePattern pattern_;
  NumberFields fields_;
  double fitted_to_ = 0;               // diagonal [m] that the lengths were set from
  std::vector<HoleOutline> outlines_;  // around the selected point, until they are drawn
};

}  // namespace kerf
