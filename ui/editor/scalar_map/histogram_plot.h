#pragma once

#include "ui/editor/scalar_map/histogram.h"

namespace kerf {

// Draws a histogram over the width of the panel, in the colours that its values have in the picture, with a
// handle for each end of the range, which the mouse drags; they never come closer than a hundredth of the
// histogram. The heights of its columns are the square roots of their counts, so that few faces show beside
// many. Landmarks: "scalar low" and "scalar high". Returns whether the range was changed.
bool draw_histogram(const Histogram& histogram, ScalarRange& range);

}  // namespace kerf
