#include "ui/editor/shared/thumbnails.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "ui/gl/context.h"

namespace kerf::test {
namespace {

Pixels of_one_colour(int width, int height, uint8_t grey) {
  return {width, height, std::vector<uint8_t>(3 * static_cast<size_t>(width * height), grey)};
}

class ThumbnailsTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(context_.ok()) << context_.error().message; }
  uint8_t grey_of(const std::filesystem::path& file) {
    const std::optional<TipPicture> found = thumbnails_.find(file);
    if (!found) return 0;
    std::vector<uint8_t> texels(3 * Thumbnails::kWidth * Thumbnails::kHeight);
    glBindTexture(GL_TEXTURE_2D, found->texture);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    return texels.front();
  }

  Result<gl::OffscreenContext> context_ = gl::OffscreenContext::create();
  TemporaryFolder folder_;
  Thumbnails thumbnails_{folder_ / "thumbnails"};
};

TEST_F(ThumbnailsTest, show_the_latest_saved_state_of_each_file) {
  EXPECT_FALSE(thumbnails_.find("/one.kerf"));
  ASSERT_TRUE(thumbnails_.keep("/one.kerf", of_one_colour(1200, 700, 10)).ok());
  ASSERT_TRUE(thumbnails_.keep("/two.kerf", of_one_colour(640, 900, 20)).ok());
  EXPECT_EQ(grey_of("/one.kerf"), 10);
  EXPECT_EQ(grey_of("/two.kerf"), 20);
  ASSERT_TRUE(thumbnails_.keep("/one.kerf", of_one_colour(1200, 700, 30)).ok());
  EXPECT_EQ(grey_of("/one.kerf"), 30);
  EXPECT_EQ(thumbnails_.find("/one.kerf")->size, Vec2(Thumbnails::kWidth, Thumbnails::kHeight));
}

TEST_F(ThumbnailsTest, persist_across_sessions) {
  ASSERT_TRUE(thumbnails_.keep("/one.kerf", of_one_colour(800, 500, 10)).ok());
  thumbnails_ = Thumbnails(folder_ / "thumbnails");
  EXPECT_EQ(grey_of("/one.kerf"), 10);
}

TEST_F(ThumbnailsTest, of_dropped_files_are_deleted_and_nothing_else) {
  for (const char* file : {"/one.kerf", "/two.kerf", "/three.kerf"})
    ASSERT_TRUE(thumbnails_.keep(file, of_one_colour(800, 500, 10)).ok());
  write_text(folder_ / "thumbnails/notes.txt", "a user's");
  thumbnails_.keep_only(std::vector<std::filesystem::path>{"/two.kerf", "/four.kerf"});
  EXPECT_FALSE(thumbnails_.find("/one.kerf"));
  EXPECT_TRUE(thumbnails_.find("/two.kerf"));
  EXPECT_FALSE(thumbnails_.find("/three.kerf"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "thumbnails"), {}), 2);
}

TEST_F(ThumbnailsTest, failed_write_keeps_the_previous_one) {
  ASSERT_TRUE(thumbnails_.keep("/one.kerf", of_one_colour(800, 500, 10)).ok());
  write_text(folder_ / "file", "");
  Thumbnails nowhere(folder_ / "file");
  EXPECT_FALSE(nowhere.keep("/one.kerf", of_one_colour(800, 500, 20)).ok());
  EXPECT_EQ(grey_of("/one.kerf"), 10);
}

}  // namespace
}  // namespace kerf::test
