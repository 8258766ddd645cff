#include "ui/editor/path/kept_path.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

class KeptPathTest : public testing::Test {
 protected:
  void add_point(double x) {
    path.begin_edit();
    path.add({{x, 1, 0}, {0, -1, 0}}, 1, false, 0.01, 2);
  }
  size_t files() const {
    return static_cast<size_t>(
        std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
  }
  const test::TemporaryFolder folder;
  PathWork path;
};

TEST_F(KeptPathTest, what_is_not_saved_is_found_by_the_next_editor_and_not_by_one_beside_it) {
  {
    KeptPath kept(folder.path());
    add_point(0);
    add_point(1);
    ASSERT_TRUE(kept.follow(path).ok());
    EXPECT_FALSE(KeptPath(folder.path()).adopt().has_value());
  }
  KeptPath next(folder.path());
  const auto left = next.adopt();
  ASSERT_TRUE(left.has_value());
  ASSERT_EQ(left->size(), 1u);
  EXPECT_EQ(left->front().keys.back().origin, Vec3(1, 1, 0));
  EXPECT_EQ(files(), 1u);
}

TEST_F(KeptPathTest, one_file_follows_the_edits_and_goes_when_the_path_is_saved) {
  KeptPath kept(folder.path());
  for (int i = 0; i < 3; ++i) {
    add_point(i);
    ASSERT_TRUE(kept.follow(path).ok());
    EXPECT_EQ(files(), 1u);
  }
  path.note_saved("path.json");
  ASSERT_TRUE(kept.follow(path).ok());
  EXPECT_EQ(files(), 0u);
}

TEST_F(KeptPathTest, a_file_that_cannot_be_read_is_left_alone) {
  test::write_text(folder / "path-1-1.json", "{");
  KeptPath kept(folder.path());
  EXPECT_FALSE(kept.adopt().has_value());
  EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace kerf
