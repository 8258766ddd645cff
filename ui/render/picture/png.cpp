#include "ui/render/picture/png.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "core/base/assert.h"
#include "core/base/atomic_file.h"

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace kerf {

Pixels read_pixels(unsigned framebuffer, int width, int height) {
  Pixels pixels{width, height,
                std::vector<uint8_t>(3 * static_cast<size_t>(width) * static_cast<size_t>(height))};
  const size_t row = 3 * static_cast<size_t>(width);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.rgb.data());
  for (size_t low = 0, high = static_cast<size_t>(height); low + 1 < high--; ++low) {
    std::swap_ranges(pixels.rgb.begin() + static_cast<std::ptrdiff_t>(low * row),
                     pixels.rgb.begin() + static_cast<std::ptrdiff_t>((low + 1) * row),
                     pixels.rgb.begin() + static_cast<std::ptrdiff_t>(high * row));
  }
  return pixels;
}

std::filesystem::path frame_file(const std::filesystem::path& folder, size_t frame) {
  char name[40];
  std::snprintf(name, sizeof name, "frame-%05zu.png", frame);
  return folder / name;
}

Status write_png(const Pixels& pixels, const std::filesystem::path& file) {
  KERF_ASSERT(pixels.rgb.size() ==
              3 * static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height));
  std::string bytes;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<size_t>(size));
  };
  if (!stbi_write_png_to_func(append, &bytes, pixels.width, pixels.height, 3, pixels.rgb.data(),
                              3 * pixels.width)) {
    return failed(file.string() + ": the picture cannot be packed");
  }
  return write_file_atomically(file, bytes);
}

}  // namespace kerf
