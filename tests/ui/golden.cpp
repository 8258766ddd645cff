#include "tests/ui/golden.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/ui/render/stage.h"

namespace kerf::test {

namespace {

constexpr double kMeanTolerance = 2;      // of 255
constexpr double kPixelTolerance = 0.01;  // of the pixels may be off by more than 24 of 255

}  // namespace

void expect_golden(const std::filesystem::path& golden, const Pixels& drawn) {
  if (std::getenv("KERF_MAKE_GOLDEN") != nullptr) {
    EXPECT_TRUE(write_png(drawn, golden).ok());
    return;
  }
  const PictureDifference off = difference(read_png(golden).value_or(Pixels{}), drawn);
  EXPECT_LE(off.mean, kMeanTolerance) << golden;
  EXPECT_LE(off.changed, kPixelTolerance) << golden;
  if (off.mean <= kMeanTolerance && off.changed <= kPixelTolerance) return;
  const auto here = std::filesystem::temp_directory_path() / golden.filename();
  if (write_png(drawn, here).ok()) std::printf("as drawn now: %s\n", here.c_str());
}

}  // namespace kerf::test
