#include "core/base/platform.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  fs::path file() const { return folder_ / "file.txt"; }
  size_t files() const {
    return static_cast<size_t>(
        std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }

  test::TemporaryFolder folder_;
};

TEST_F(AtomicFile, replaces_the_previous_content_completely) {
  ASSERT_TRUE(write_file_atomically(file(), "first\n"));
  EXPECT_EQ(test::read_text(file()), "first\n");
  ASSERT_TRUE(write_file_atomically(file(), std::string(3 << 20, 'x')));
  EXPECT_EQ(test::read_text(file()).size(), size_t{3} << 20);
  EXPECT_EQ(files(), 1u) << "no temporary file is left";
}

TEST_F(AtomicFile, keeps_its_permissions) {
  ASSERT_TRUE(write_file_atomically(file(), "first\n"));
  fs::permissions(file(), fs::perms::owner_read | fs::perms::owner_write | fs::perms::owner_exec);
  ASSERT_TRUE(write_file_atomically(file(), "second\n"));
  EXPECT_EQ(fs::status(file()).permissions(), fs::perms::owner_all);
}

TEST_F(AtomicFile, does_not_replace_a_read_only_file) {
  ASSERT_TRUE(write_file_atomically(file(), "first\n"));
  fs::permissions(file(), fs::perms::owner_read);
  if (::geteuid() == 0) GTEST_SKIP() << "root may write read-only files";
  EXPECT_FALSE(write_file_atomically(file(), "second\n"));
  EXPECT_EQ(test::read_text(file()), "first\n");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, writes_through_a_symlink) {
  ASSERT_TRUE(write_file_atomically(file(), "first\n"));
  fs::create_symlink(file(), folder_ / "link.txt");
  ASSERT_TRUE(write_file_atomically(folder_ / "link.txt", "linked\n"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(test::read_text(file()), "linked\n");
}

TEST_F(AtomicFile, creates_the_file_that_a_symlink_names) {
  fs::create_directory(folder_ / "there");
  fs::create_symlink("there/link.txt", folder_ / "link.txt");
  fs::create_symlink(file(), folder_ / "there" / "link.txt");
  ASSERT_TRUE(write_file_atomically(folder_ / "link.txt", "linked\n"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "there" / "link.txt"));
  EXPECT_EQ(test::read_text(file()), "linked\n");
}

TEST_F(AtomicFile, names_the_missing_folder_to_which_a_symlink_leads) {
  fs::create_symlink(folder_ / "away" / "file.txt", folder_ / "link.txt");
  const Status written = write_file_atomically(folder_ / "link.txt", "linked\n");
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().message.find("there is no folder " + (folder_ / "away").string()),
            std::string::npos)
      << written.error().message;
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
}

TEST_F(AtomicFile, appends_to_a_file_to_which_standard_output_is_redirected) {
  ASSERT_TRUE(write_file_atomically(file(), "first\n"));
  std::fflush(stdout);
  const int before = ::dup(STDOUT_FILENO), redirected = ::open(file().c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(std::min(before, redirected), 0);
  ASSERT_GE(::dup2(redirected, STDOUT_FILENO), 0);
  const bool written = write_file_atomically("/dev/stdout", "second\n").ok();
  ::dup2(before, STDOUT_FILENO);
  ::close(before);
  ::close(redirected);
  EXPECT_TRUE(written);
  EXPECT_EQ(test::read_text(file()), "first\nsecond\n");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, leaves_the_old_file_if_its_content_cannot_be_produced) {
  ASSERT_TRUE(write_file_atomically(file(), "first\n"));
  const auto fails = [](const ByteSink& sink) {
    sink("half");
    throw std::runtime_error("no more");
  };
  EXPECT_THROW((void)write_file_atomically(file(), fails), std::runtime_error);
  EXPECT_EQ(test::read_text(file()), "first\n");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, names_a_missing_folder_in_the_error) {
  const Status written = write_file_atomically(folder_ / "gone" / "file.txt", "text");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find("file.txt"), std::string::npos) << written.error().message;
  EXPECT_EQ(written.error().message.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace kerf
