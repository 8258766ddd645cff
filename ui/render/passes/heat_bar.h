#pragma once

#include "ui/render/passes/face_numbers.h"

namespace kerf {

// The temperature at which the scale of the temperature view ends (K): the highest at which a material of the
// world melts or decomposes.
double end_of_heat_scale(const World& world);

// Draws the scale from the ambient to `end` (K) over the bound picture, at its lower left, with numbers in
// kelvin beside it. `height` is that of the picture in pixels. Precondition: `end` is above the ambient.
void draw_heat_bar(double end, FaceNumbers& numbers, int height);

}  // namespace kerf
