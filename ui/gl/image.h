#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
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

// Crops an image to at most these columns and rows from column x and row y on. Precondition: there is such
// a pixel, and the size is positive.
Pixels cut_out(const Pixels& all, int x, int y, int width, int height);

// Returns the largest centred part of an image with the proportions of this size, downscaled to it by
// averaging; never enlarges. Preconditions: neither the image nor the size is empty.
Pixels shrunk(const Pixels& all, int width, int height);

// The file of a frame of a film, counted from 0: "frame-00000.png" and so on.
std::filesystem::path frame_file(const std::filesystem::path& folder, size_t frame);
// Removes the frames of an earlier, longer film from the folder of a film of `count` frames: all files named
// like a frame from `count` on. Fails if one cannot be removed. O(files in the folder).
Status remove_later_frames(const std::filesystem::path& folder, size_t count);

// Writes a PNG atomically. Precondition: the number of bytes matches the size.
Status write_png(const Pixels& pixels, const std::filesystem::path& file);

// Reads a PNG. Returns nullopt if the file is missing or damaged.
std::optional<Pixels> read_png(const std::filesystem::path& file);

// Rows of RGBA from the top, 8 bits each.
struct TexturePixels {
  int width = 0, height = 0;
  std::vector<uint8_t> rgba;
};

// Decodes a PNG, JPEG, BMP or TGA image. Returns nullopt if it is damaged, of another format, or larger than
// kMaxTextureSide on a side.
inline constexpr int kMaxTextureSide = 1 << 14;
std::optional<TexturePixels> decode_texture(std::string_view bytes);

// Returns an image resized to a square, for `colours` with the mean of their light, weighted by their
// opacity. Precondition: the image is not empty, and side > 0.
TexturePixels resized(const TexturePixels& from, int side, bool colours);

}  // namespace kerf
