#pragma once

#include "ui/render/view/view_options.h"

namespace kerf {

enum class Theme { kDark, kLight };

struct GuiLook {
  Theme theme = Theme::kDark;
  BoxPalette palette = BoxPalette::kRedAndGreen;  // determines the accent colour
  float scale = 1;                                // of text and sizes; 1 gives text of 15.5 pixels
  bool own_font = false;                          // uses ImGui's own font even if a better one is installed
  friend bool operator==(const GuiLook&, const GuiLook&) = default;
};

}  // namespace kerf
