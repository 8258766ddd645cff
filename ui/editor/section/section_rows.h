#pragma once

#include "ui/editor/shared/view_state.h"
#include "ui/window/message.h"
#include "ui/window/number_fields.h"

namespace kerf {

// Rows of a panel while the section plane is shown: its point and its normal as numbers that can be typed, in
// the numbers of the file, and buttons that flip, turn, copy and paste it.
class SectionRows {
 public:
  void draw(ViewState& view, Message& message);

 private:
  NumberFields fields_;
};

}  // namespace kerf
