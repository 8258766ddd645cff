#pragma once

#include <functional>

#include "ui/editor/path/emitter.h"
#include "ui/window/number_fields.h"

namespace kerf {

// The rows of the Laser panel for the emitter: buttons that place it, switch it and take it away, and its
// place and aim as numbers.
class EmitterRows {
 public:
  // `place` puts the emitter where the view looks.
  void draw(Emitter& emitter, const std::function<void()>& place);

 private:
  NumberFields fields_;
};

}  // namespace kerf
