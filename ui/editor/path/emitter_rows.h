#pragma once

#include <functional>

#include "ui/editor/path/emitter.h"
#include "ui/editor/shared/view_state.h"
#include "ui/window/number_fields.h"

namespace kerf {

// The rows of the Laser panel for the emitter: buttons that place it, switch it and take it away, its pace,
// and its place and aim as numbers.
class EmitterRows {
 public:
  // `place` puts the emitter where the view looks.
  void draw(Emitter& emitter, const ViewState& view, const std::function<void()>& place);

 private:
  void draw_pace(Emitter& emitter);

  NumberFields fields_;
};

}  // namespace kerf
