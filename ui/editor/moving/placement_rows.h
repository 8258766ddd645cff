#pragma once

#include "core/document/commands/command.h"
#include "ui/editor/shared/picture/view_state.h"
#include "ui/window/number_fields.h"

namespace kerf {

// Angles in degrees about the axes of the world: the orientation turns about X first, then about Y, then
// about Z. The angle about Y is within 90 degrees of 0.
Vec3 angles_of(const glm::dquat& orientation);
glm::dquat orientation_of(const Vec3& angles);

// Where the chosen piece stands as numbers that can be typed: its centre of area in the unit of the file, and
// its angles, which turn it about this centre.
class PlacementRows {
 public:
  // Where not exactly one piece is chosen the fields are empty, so that what is below stays in its place when
  // one is. Enter or leaving a field returns the command.
  std::optional<Command> draw(const World& world, const ViewState& view);

 private:
  std::optional<Command> draw_fields(const World& world, const ViewState& view, const PieceId& piece);
  void draw_empty(const char* why);

  NumberFields fields_;
};

}  // namespace kerf
