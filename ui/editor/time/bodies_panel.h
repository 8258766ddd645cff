#pragma once

#include "ui/editor/time/body_actions.h"
#include "ui/window/number_fields.h"

namespace kerf {

// Play, pause and speed, gravity and ground, pins, the views of contacts, and what the last tick did.
class BodiesPanel {
 public:
  void draw(Workspace& on, PlayState& play);

 private:
  void draw_surroundings(Workspace& on);

  NumberFields fields_;
};

}  // namespace kerf
