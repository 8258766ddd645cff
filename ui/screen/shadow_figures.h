#pragma once

#include <cstddef>

namespace kerf {

// What the views that inspect shadows found in the last picture.
struct ShadowFigures {
  size_t differing = 0;  // pixels that two methods draw differently
  double traced = 0;     // share of the picture's pixels whose shadow rays are traced, 0 to 1
  size_t wrong = 0;      // traced pixels whose shadow differs from the drawn one
};

}  // namespace kerf
