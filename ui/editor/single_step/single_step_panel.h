#pragma once

#include "core/document/document.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/single_step/stage_cut.h"

namespace kerf {

// Panel of single steps: the switch, the buttons for the stages, and a description of each stage.
class SingleStepPanel {
 public:
  void draw(StageState& stages, const Document& document, const ViewState& view);

 private:
  void draw_list(StageState& stages, const Document& document);

  size_t shown_ = 0;  // stage that the list was last scrolled to
};

}  // namespace kerf
