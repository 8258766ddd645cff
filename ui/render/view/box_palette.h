#pragma once

#include <cstdint>

#include "ui/render/view/view_options.h"

namespace kerf {

// The two colours of a palette as 0xrrggbb (sRGB).
struct BoxColours {
  uint32_t hit = 0;        // drawn solid
  uint32_t untouched = 0;  // drawn dotted
};

constexpr BoxColours colours_of(BoxPalette palette) {
  return palette == BoxPalette::kRedAndGreen ? BoxColours{0xff6a4d, 0x3fbf7f}
                                             : BoxColours{0xe69f00, 0x56b4e9};
}

// The colour of the selection: amber, or blue in the palette in which orange marks boxes that the beam has
// hit.
constexpr uint32_t selection_colour(BoxPalette palette) {
  return palette == BoxPalette::kRedAndGreen ? 0xff9d2e : 0x4aa3ff;
}

}  // namespace kerf
