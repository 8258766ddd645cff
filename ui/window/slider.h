#pragma once

#include <string>

#include "ui/window/number_expression.h"
#include "ui/window/number_format.h"

namespace kerf {

struct Slider {
  const char* name;     // in messages
  const char* id;       // of ImGui
  const char* meaning;  // the tooltip
  bool logarithmic = false;
  bool takes_text = true;  // Ctrl+click, and Tab, make it a number field (see NumberFields)
};

// Draws a slider as wide as the next item. The value stands beside the grab, shortened if it does not fit
// there, and the tooltip has all of it then. What is typed is limited to the range, with a message. Returns
// whether the value was changed. `text` is shown in place of the number unless it is empty.
bool real_slider(const Slider& slider, double& value, double low, double high, const RealFormat& format,
                 const NumberUnit& unit = {}, const std::string& text = "");
bool whole_slider(const Slider& slider, int& value, int low, int high, const std::string& text,
                  const NumberUnit& unit = {});

// Where the text of a slider stands between `left` and `right`: in the middle, or as near to it as the grab,
// which is in between, leaves room for it.
struct SliderRoom {
  float at = 0, width = 0;
};
SliderRoom room_beside_grab(float left, float right, float grab_left, float grab_right, float text_width);

}  // namespace kerf
