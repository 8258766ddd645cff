#pragma once

#include "ui/editor/laser/waiting_strokes.h"
#include "ui/editor/shared/laser/laser_tool.h"
#include "ui/editor/shared/picture/view_state.h"
#include "ui/screen/particles.h"

namespace kerf {

// The effects of the editor's laser: sparks and smoke where it removes faces, as long as the view's switch is
// on, and the beams of strokes that wait.
class BeamSparks {
 public:
  // Lets time pass (s) for them and shows them in the view. `waiting_changed`: since the last call.
  void advance(double seconds, const LaserTool& beam, const Document& document, const WaitingStrokes& waiting,
               bool waiting_changed, ViewState& view);
  // Whether some are in the air.
  bool moving() const { return !particles_.empty(); }

 private:
  Particles particles_;
  bool had_particles_ = false;
  double removed_ = 0;  // kg, when it was last looked
};

}  // namespace kerf
