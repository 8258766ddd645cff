#pragma once

#include "core/shadow/shadow_volume.h"

namespace kerf {

// How kRobust draws the near caps of its volumes. A surface that is lit has to fail against its own cap,
// which lies where it does: all but kExact are wrong, and are there for tests to show that they would notice.
enum class NearCaps {
  kExact,
  kLessOrEqual,  // equal depths pass
  kDisplaced,    // by one step of the depth towards the eye
};

// How shadows are cast where ShowOptions asks for them.
struct ShadowOptions {
  ShadowMethod method = ShadowMethod::kRobust;
  NearCaps near_caps = NearCaps::kExact;
  // How far the paper's volumes reach, in diagonals of the world; kRobust reaches without end.
  double extrusion = 4;
  // Black at half strength over what is in shadow, as in the paper, in place of leaving the light out.
  bool paper_look = false;
  // The method that is drawn right of the split where ShowOptions asks to compare; `split` is a share of the
  // picture's width.
  ShadowMethod beside = ShadowMethod::kPaperOneVolume;
  double split = 0.5;
  size_t inspected = 0;  // the light whose silhouette, volumes and counts are shown
  friend bool operator==(const ShadowOptions&, const ShadowOptions&) = default;
};

}  // namespace kerf
