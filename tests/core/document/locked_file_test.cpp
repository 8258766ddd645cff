#include "core/document/autosave.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

class LockedFileTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "work.kerf"; }

  test::TemporaryFolder folder_;
};

TEST_F(LockedFileTest, is_created_with_its_content_and_can_be_appended_to) {
  auto locked = LockedFile::create(file(), "head\n");
  ASSERT_TRUE(locked) << locked.error().message;
  EXPECT_EQ(test::read_text(file()), "head\n");
  ASSERT_TRUE(locked->append("line\n"));
  EXPECT_EQ(test::read_text(file()), "head\nline\n");
  while (locked->flush()) {
  }
  EXPECT_EQ(locked->path(), file());
}

TEST_F(LockedFileTest, cannot_be_created_or_locked_twice) {
  auto locked = LockedFile::create(file(), "head\n");
  ASSERT_TRUE(locked);
  EXPECT_FALSE(LockedFile::create(file(), "other\n"));
  EXPECT_FALSE(LockedFile::open(file()));
  EXPECT_EQ(test::read_text(file()), "head\n");
}

TEST_F(LockedFileTest, is_unlocked_when_its_owner_is_destroyed) {
  { ASSERT_TRUE(LockedFile::create(file(), "head\n")); }
  auto again = LockedFile::open(file());
  ASSERT_TRUE(again) << again.error().message;
  ASSERT_TRUE(again->append("more\n"));
  EXPECT_EQ(test::read_text(file()), "head\nmore\n");
}

TEST_F(LockedFileTest, stays_locked_when_moved) {
  auto locked = LockedFile::create(file(), "head\n");
  ASSERT_TRUE(locked);
  LockedFile other = std::move(*locked);
  EXPECT_FALSE(LockedFile::open(file()));
  EXPECT_TRUE(other.append("line\n"));
  other.remove();
  EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(LockedFileTest, is_replaced_with_its_path_by_a_move_assignment) {
  const auto other = folder_ / "other.kerf";
  auto one = LockedFile::create(file(), "one\n"), two = LockedFile::create(other, "two\n");
  ASSERT_TRUE(one && two);
  *one = std::move(*two);
  EXPECT_EQ(one->path(), other);
  ASSERT_TRUE(one->append("line\n"));
  EXPECT_EQ(test::read_text(other), "two\nline\n");
  one->remove();
  EXPECT_FALSE(std::filesystem::exists(other));
  EXPECT_TRUE(std::filesystem::exists(file()));
}

TEST_F(LockedFileTest, fails_to_open_a_missing_file) { EXPECT_FALSE(LockedFile::open(file())); }

}  // namespace
}  // namespace kerf
