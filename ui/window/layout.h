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

// The layout of the window: menu at the top, status bar at the bottom, panels at the right, and the picture
// in the remaining area. In a narrow window the panels shrink, and disappear if they would have no usable
// width.
struct Layout {
  Area viewport, side, status;
  // The halves of the viewport if it is split; otherwise `first` is all of it, and `second` has no width.
  Area first, second;
  double em = 16;  // the size of the text
  bool split() const { return second.size.x > 0; }
};

// Computes the layout. `em` is the size of the text, `menu` and `status` are the heights of these bars, and
// `side_ems` is the desired width of the panels in sizes of the text (0: none).
Layout lay_out(Vec2 window, double em, double menu, double status, double side_ems = 21);

// Splits the viewport in two. The left half takes this fraction of its width, limited so that both halves
// stay usable. Preconditions: it is whole, and the fraction is from 0 to 1.
Layout split_in_two(Layout whole, double share);

}  // namespace kerf
