#pragma once

#include <optional>

#include "core/shadow/shadow_volume.h"

namespace kerf {

// How shadows are cast where ShowOptions asks for them.
struct ShadowOptions {
  ShadowMethod method = ShadowMethod::kRobust;
  // How far the paper's volumes reach, in diagonals of the world; kRobust reaches without end.
  double extrusion = 4;
  // Black at half strength over what is in shadow, as in the paper, in place of leaving the light out.
  bool paper_look = false;
  // The method that is drawn right of the split, to compare; `split` is a share of the picture's width.
  std::optional<ShadowMethod> beside;
  double split = 0.5;
  friend bool operator==(const ShadowOptions&, const ShadowOptions&) = default;
};

}  // namespace kerf
