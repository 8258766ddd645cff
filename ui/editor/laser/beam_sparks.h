#pragma once

#include "ui/editor/shared/laser/laser_tool.h"
#include "ui/editor/shared/picture/view_state.h"
#include "ui/screen/particles.h"

namespace kerf {

// The sparks and the smoke where the laser of the editor removes faces, as long as the view's switch is on.
class BeamSparks {
 public:
  // Lets time pass (s) for them and shows them in the view.
  void advance(double seconds, const LaserTool& beam, const Document& document, ViewState& view);
  // Whether some are in the air.
  bool moving() const { return !particles_.empty(); }

 private:
  Particles particles_;
  double removed_ = 0;  // kg, when it was last looked
};

}  // namespace kerf
