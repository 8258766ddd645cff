#pragma once

#include "ui/editor/view/settings.h"
#include "ui/editor/view/view_state.h"

namespace kerf {

// Theme and size of the text.
class DisplayPanel {
 public:
  void draw(Settings& settings, const ViewState& view);

 private:
  double wanted_scale_ = 0;  // of the text, while its slider moves
};

}  // namespace kerf
