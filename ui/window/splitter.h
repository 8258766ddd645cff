#pragma once

#include <optional>

#include "core/base/vec3.h"

namespace kerf {

// What the user did to a splitter in a frame.
struct SplitterMove {
  std::optional<double> dragged;  // the x coordinate that it was dragged to, screen coordinates
  bool reset = false;             // it was double-clicked
};

// Draws a vertical strip of the given height at `top` that can be dragged sideways. `tip` is its tooltip.
SplitterMove splitter(const char* id, Vec2 top, double height, const char* tip);

}  // namespace kerf
