#pragma once

#include "ui/editor/figures/figures.h"

namespace kerf {

// What the last steps took and changed, and where memory goes.
void draw_statistics_panel(const StepChart& chart, const ShownFigures& shown);

}  // namespace kerf
