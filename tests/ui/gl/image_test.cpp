#include "ui/gl/image.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/random.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

Pixels random_pixels(int width, int height, Random& random) {
  Pixels pixels{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) pixels.rgb.push_back(static_cast<uint8_t>(random.below(256)));
  return pixels;
}

const uint8_t* pixel(const Pixels& all, int x, int y) {
  return &all.rgb[3 * static_cast<size_t>(y * all.width + x)];
}

TEST(Png, round_trips) {
  const TemporaryFolder folder;
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Pixels written = random_pixels(1 + int(random.below(40)), 1 + int(random.below(40)), random);
    ASSERT_TRUE(write_png(written, folder / "some.png").ok());
    const std::optional<Pixels> read = read_png(folder / "some.png");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->width, written.width);
    EXPECT_EQ(read->height, written.height);
    EXPECT_EQ(read->rgb, written.rgb);
  }
}

TEST(Png, fails_to_read_if_damaged_or_missing) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_png(folder / "none.png"));
  Random random(2);
  ASSERT_TRUE(write_png(random_pixels(30, 30, random), folder / "some.png").ok());
  const std::string bytes = read_text(folder / "some.png");
  write_text(folder / "half.png", bytes.substr(0, bytes.size() / 2));
  EXPECT_FALSE(read_png(folder / "half.png"));
  write_text(folder / "text.png", "no picture");
  EXPECT_FALSE(read_png(folder / "text.png"));
}

TEST(Frames, of_a_longer_film_are_removed_and_other_files_are_kept) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "frame-00007.png");
  const std::vector<std::string> kept{
      "frame-00000.png",   "frame-00001.png", "frame-0002.png",
      "frame-000002.png",  "frame-00002.jpg", "frame-00002.png~",
      "frame--0002.png",   "frame-.png",      "frame-99999999999999999999.png",
      "my-frame-00002.png"};
  const std::vector<std::string> later{"frame-00002.png", "frame-00099.png", "frame-100000.png"};
  for (const auto* const names : {&kept, &later}) {
    for (const std::string& name : *names) write_text(folder / name, name);
  }
  ASSERT_TRUE(remove_later_frames(folder.path(), 2).ok());
  for (const std::string& name : kept) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  for (const std::string& name : later) EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
  EXPECT_TRUE(std::filesystem::is_directory(folder / "frame-00007.png"));
}

TEST(CutOut, copies_the_region_and_is_clamped_to_the_image) {
  Random random(3);
  const Pixels all = random_pixels(17, 11, random);
  const Pixels part = cut_out(all, 5, 3, 7, 100);
  ASSERT_EQ(part.width, 7);
  ASSERT_EQ(part.height, 8);
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) {
      EXPECT_TRUE(std::equal(pixel(part, x, y), pixel(part, x, y) + 3, pixel(all, x + 5, y + 3)));
    }
  }
}

TEST(Shrunk, averages_pixels_and_crops_to_the_aspect_ratio) {
  Random random(4);
  const Pixels all = random_pixels(32, 10, random);  // of which the middle 16 x 10 are taken
  const Pixels small = shrunk(all, 8, 5);
  ASSERT_EQ(small.width, 8);
  ASSERT_EQ(small.height, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 8; ++x) {
      for (int c = 0; c < 3; ++c) {
        int sum = 0;
        for (int i = 0; i < 4; ++i) sum += pixel(all, 8 + 2 * x + i % 2, 2 * y + i / 2)[c];
        EXPECT_EQ(pixel(small, x, y)[c], (sum + 2) / 4);
      }
    }
  }
}

TEST(Shrunk, never_enlarges) {
  Random random(5);
  const Pixels all = random_pixels(20, 9, random);
  const Pixels same = shrunk(all, 200, 90);
  EXPECT_EQ(same.width, 20);
  EXPECT_EQ(same.height, 9);
  EXPECT_EQ(same.rgb, all.rgb);
}

TEST(Resized, only_colours_are_weighted_by_their_opacity) {
  const TexturePixels from{2, 1, {255, 0, 0, 255, 0, 0, 0, 0}};
  EXPECT_NEAR(resized(from, 1, true).rgba[0], 255, 2);
  EXPECT_NEAR(resized(from, 1, false).rgba[0], 128, 2);
}

}  // namespace
}  // namespace kerf::test
