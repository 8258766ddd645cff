#pragma once

#include "core/base/vec3.h"

namespace kerf {

// A rectangle of the window in screen coordinates, from its upper left corner.
struct Area {
  Vec2 at{0}, size{0};
  bool contains(Vec2 p) const {
    return p.x >= at.x && p.y >= at.y && p.x < at.x + size.x && p.y < at.y + size.y;
  }
  friend bool operator==(const Area&, const Area&) = default;
};

// The layout of the window: menu at the top, status bar at the bottom, panels at the right, at the left and
// below, and the picture in the remaining area. In a small window the panels shrink, and disappear if they
// would have no usable size.
struct Layout {
  Area viewport, side, second_side, strip, status;
  // The halves of the viewport if it is split; otherwise `first` is all of it, and `second` has no width.
  Area first, second;
  double em = 16;  // the size of the text
  bool split() const { return second.size.x > 0; }
};

// The desired sizes of the areas of panels, in sizes of the text; 0: none.
struct PanelSizes {
  double side = 21, second_side = 0;  // widths at the right and at the left
  double strip = 0;                   // height below the picture
};

// Computes the layout. `em` is the size of the text, `menu` and `status` are the heights of these bars.
Layout lay_out(Vec2 window, double em, double menu, double status, const PanelSizes& panels = {});

// Splits the viewport in two. The left half takes this fraction of its width, limited so that both halves
// stay usable. Preconditions: it is whole, and the fraction is from 0 to 1.
Layout split_in_two(Layout whole, double share);

}  // namespace kerf
