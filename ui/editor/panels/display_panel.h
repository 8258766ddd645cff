#pragma once

#include "ui/editor/view/settings.h"

namespace kerf {

// Theme and size of the text.
class DisplayPanel {
 public:
  void draw(Settings& settings);

 private:
  double wanted_scale_ = 0;  // of the text, while its slider moves
};

}  // namespace kerf
