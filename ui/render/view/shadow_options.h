#pragma once

#include "core/shadow/shadow_volume.h"

namespace kerf {

// How kRobust draws the near caps of its volumes. A lit surface has to fail the depth test against its own
// cap, which has the same depth. All values but kExact give wrong shadows; tests use them to show that they
// detect such errors.
enum class NearCaps {
  kExact,
  kLessOrEqual,  // equal depths pass
  kDisplaced,    // by one unit of depth towards the eye
};

// How shadows are drawn if ShowOptions enables them.
struct ShadowOptions {
  ShadowMethod method = ShadowMethod::kRobust;
  NearCaps near_caps = NearCaps::kExact;
  // Length of the paper's volumes in diagonals of the world; those of kRobust extend to infinity.
  double extrusion = 4;
  // Whether shadows are drawn as half-transparent black, as in the paper, instead of omitting the light.
  bool paper_look = false;
  // The method to the right of the split if ShowOptions compares two; `split` is a fraction of the picture's
  // width.
  ShadowMethod beside = ShadowMethod::kPaperOneVolume;
  double split = 0.5;
  size_t inspected = 0;  // the light whose silhouette, volumes and counts are shown
  friend bool operator==(const ShadowOptions&, const ShadowOptions&) = default;
};

}  // namespace kerf
