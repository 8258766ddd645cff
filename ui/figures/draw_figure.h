#pragma once

#include "ui/figures/figure.h"

namespace kerf {

struct FigureSize {
  int width = 1280, height = 720;  // pixels, with the caption; >= 64
};

// Draws a figure with its caption below, without a window, and writes it as a PNG atomically. The output is
// byte-identical on one machine. Fails if one of its files cannot be read, OpenGL is not available, or the
// PNG cannot be written.
Status draw_figure(const Figure& figure, const FigureSize& size, const std::filesystem::path& png);

}  // namespace kerf
