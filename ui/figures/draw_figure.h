#pragma once

#include "ui/figures/figure.h"

namespace kerf {

struct FigureSize {
  int width = 1280, height = 720;  // pixels, with the caption; at least 64
};

// Draws a figure without a screen, with its caption below, and writes it as a PNG, whole or not at all. The
// same figure gives the same bytes on one machine. Fails if one of its files cannot be read, OpenGL is not
// available, or the PNG cannot be written.
Status draw_figure(const Figure& figure, const FigureSize& size, const std::filesystem::path& png);

}  // namespace kerf
