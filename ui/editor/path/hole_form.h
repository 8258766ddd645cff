#pragma once

#include "core/mesh/files/file_frame.h"
#include "ui/editor/path/hole_pattern.h"
#include "ui/editor/path/path_work.h"
#include "ui/window/number_fields.h"

namespace kerf {

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

}  // namespace kerf
