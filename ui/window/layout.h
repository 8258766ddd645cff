#pragma once

#include "core/base/vec3.h"

namespace kerf {

// A rectangle of the window in screen coordinates, from its upper left corner.
struct Area {
  Vec2 at{0}, size{0};
  bool contains(Vec2 p) const {
    return p.x >= at.x && p.y >= at.y && p.x < at.x + size.x && p.y < at.y + size.y;
  }
};

// The fixed frame of the window: menu above, status below, panels at the right, the picture in what is left.
// The panels make way for the picture in a narrow window, and go where they would have no usable width.
struct Layout {
  Area viewport, side, status;
  // The halves of the viewport where it is split; otherwise the first is all of it and the second has no
  // width.
  Area first, second;
  bool split() const { return second.size.x > 0; }
};

// `em` is the size of the text, `menu` and `status` the heights of those bars, `side_ems` the width that the
// panels are wanted at (0: not at all).
Layout lay_out(Vec2 window, double em, double menu, double status, double side_ems = 21);

// The same with the viewport split in two, the left half taking this share of its width as far as both halves
// stay wide enough to be looked at.
Layout split_in_two(Layout whole, double share);

}  // namespace kerf
