#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/result.h"

namespace kerf {

// Rows of RGB from the top, 8 bits each.
struct Pixels {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;
};

// Reads a framebuffer (0: the window) from its lower left corner.
Pixels read_pixels(unsigned framebuffer, int width, int height);

// The file of a frame of a film, counted from 0: "frame-00000.png" and so on.
std::filesystem::path frame_file(const std::filesystem::path& folder, size_t frame);

// Writes a PNG, whole or not at all. Precondition: there are as many bytes as the size says.
Status write_png(const Pixels& pixels, const std::filesystem::path& file);

}  // namespace kerf
