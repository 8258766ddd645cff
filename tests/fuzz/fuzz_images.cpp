#include <cstdlib>

#include "ui/gl/image.h"

// Decodes an image of a texture.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {  // NOLINT: libFuzzer's name
  const auto pixels = kerf::decode_texture({reinterpret_cast<const char*>(data), size});
  if (!pixels) return 0;
  const size_t expected = 4 * static_cast<size_t>(pixels->width) * static_cast<size_t>(pixels->height);
  if (pixels->width <= 0 || pixels->height <= 0 || pixels->rgba.size() != expected) std::abort();
  return 0;
}
