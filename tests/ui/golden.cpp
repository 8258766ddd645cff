#include "tests/ui/golden.h"

#include <gtest/gtest.h>
#include <stb_image.h>

#include <cstdlib>

#include "tests/ui/render/stage.h"

namespace kerf::test {

namespace {

constexpr double kMeanTolerance = 2;      // of 255
constexpr double kPixelTolerance = 0.01;  // of the pixels may be off by more than 24 of 255

}  // namespace

Pixels read_png(const std::filesystem::path& png) {
  Pixels pixels;
  int channels = 0;
  if (uint8_t* data = stbi_load(png.c_str(), &pixels.width, &pixels.height, &channels, 3)) {
    pixels.rgb.assign(data,
                      data + 3 * static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height));
    stbi_image_free(data);
  }
  return pixels;
}

void expect_golden(const std::filesystem::path& golden, const Pixels& drawn) {
  if (std::getenv("KERF_MAKE_GOLDEN") != nullptr) {
    EXPECT_TRUE(write_png(drawn, golden).ok());
    return;
  }
  const PictureDifference off = difference(read_png(golden), drawn);
  EXPECT_LE(off.mean, kMeanTolerance) << golden;
  EXPECT_LE(off.changed, kPixelTolerance) << golden;
  if (off.mean <= kMeanTolerance && off.changed <= kPixelTolerance) return;
  const auto here = std::filesystem::temp_directory_path() / golden.filename();
  if (write_png(drawn, here).ok()) std::printf("as drawn now: %s\n", here.c_str());
}

}  // namespace kerf::test
