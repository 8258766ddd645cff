#pragma once

#include "ui/render/view_options.h"

namespace kerf {

enum class Theme { kDark, kLight };

// What decides how the panels look.
struct GuiLook {
  Theme theme = Theme::kDark;
  BoxPalette palette = BoxPalette::kRedAndGreen;  // the accent goes with it
  float scale = 1;                                // of text and sizes, 1: text of 15.5 pixels
  friend bool operator==(const GuiLook&, const GuiLook&) = default;
};

}  // namespace kerf
