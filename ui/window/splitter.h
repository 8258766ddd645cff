#pragma once

#include <optional>

#include "core/base/vec3.h"

namespace kerf {

// What the user did to a splitter in a frame.
struct SplitterMove {
  std::optional<double> dragged;  // the coordinate across it that it was dragged to, screen coordinates
  bool reset = false;             // it was double-clicked
};

// Draws a vertical strip of the given height at `top` that can be dragged sideways. `tip` is its tooltip.
SplitterMove splitter(const char* id, Vec2 top, double height, const char* tip);
// Draws a horizontal strip of the given width from `left` that can be dragged up and down.
SplitterMove splitter_across(const char* id, Vec2 left, double width, const char* tip);

}  // namespace kerf
