#pragma once

#include "ui/editor/bodies/body_actions.h"
#include "ui/window/number_fields.h"

namespace kerf {

// Play, pause and speed, gravity and ground, pins, the views of contacts, and what the last tick did.
class BodiesPanel {
 public:
  // `view` is that of the parts, for its switches.
  void draw(const BodyParts& on, ViewState& view);

 private:
  void draw_surroundings(const BodyParts& on);

  NumberFields fields_;
};

}  // namespace kerf
