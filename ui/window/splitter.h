#pragma once

#include <optional>

#include "core/base/vec3.h"

namespace kerf {

// What a frame did to a splitter.
struct SplitterMove {
  std::optional<double> dragged;  // to this x, screen coordinates
  bool reset = false;             // it was double clicked
};

// A strip upright at `top`, `height` high, that can be dragged sideways. `tip` says what that does.
SplitterMove splitter(const char* id, Vec2 top, double height, const char* tip);

}  // namespace kerf
