#pragma once

#include "core/document/document.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/single_step/stage_cut.h"

namespace kerf {

// Single steps of the last stroke: the switch, the buttons that go forth and back, and what each stage did.
class SingleStepPanel {
 public:
  void draw(StageState& stages, const Document& document, const ViewState& view);

 private:
  void draw_list(StageState& stages, const Document& document);

  size_t shown_ = 0;  // the stages for which the list was scrolled
};

}  // namespace kerf
