#pragma once

#include <string>
#include <vector>

#include "ui/figures/figure.h"
#include "ui/render/view/camera.h"

namespace kerf {

// The functions below draw with the current ImGui context into the background list, which covers the picture.

// Dimension lines with arrow heads at their ends and their texts beside them.
void draw_rulers(const std::vector<Ruler>& rulers, const CameraView& view);

// Fills the picture with paper and writes a text of at most two lines on it.
void draw_caption_strip(const std::string& text);

}  // namespace kerf
