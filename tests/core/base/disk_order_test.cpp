#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/platform.h"
#include "core/document/autosave.h"
#include "tests/support/temporary_folder.h"

namespace {

// Disk operations of this program while they are recorded: "sync NAME" and "name NAME".
std::vector<std::string>* recorded = nullptr;

std::string name_of(const std::filesystem::path& path) { return path.filename().string(); }

int done(const char* what, const std::string& name, long result) {
  if (recorded != nullptr && result == 0) recorded->push_back(what + (" " + name));
  return static_cast<int>(result);
}

}  // namespace

// Replace those of the C library in this program.
extern "C" int fsync(int file) {
  std::error_code error;
  const auto path = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file), error);
  return done("sync", name_of(path), ::syscall(SYS_fsync, file));
}
extern "C" int rename(const char* from, const char* to) noexcept {
  return done("name", name_of(to), ::syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to));
}
extern "C" int link(const char* from, const char* to) noexcept {
  return done("name", name_of(to), ::syscall(SYS_linkat, AT_FDCWD, from, AT_FDCWD, to, 0));
}

namespace kerf {
namespace {

template <typename Work>
std::vector<std::string> record(const Work& work) {
  std::vector<std::string> calls;
  recorded = &calls;
  work();
  recorded = nullptr;
  return calls;
}

// A file is on the disk before it gets its name, and the name is before saving is reported. A power failure
// in between leaves the old file or the new one, each whole.
TEST(DiskOrder, saved_file_syncs_content_then_renames_then_syncs_folder) {
  const test::TemporaryFolder folder;
  const std::string name = name_of(folder.path());
  for (int i = 0; i < 2; ++i) {
    const auto calls =
        record([&] { EXPECT_TRUE(write_file_atomically(folder / "a.txt", std::to_string(i))); });
    ASSERT_EQ(calls.size(), 3u);
    EXPECT_TRUE(calls[0].starts_with("sync .a.txt.")) << calls[0];
    EXPECT_EQ(calls[1], "name a.txt");
    EXPECT_EQ(calls[2], "sync " + name);
  }
}

TEST(DiskOrder, save_through_a_symlink_syncs_the_folder_of_the_target) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "there");
  ASSERT_TRUE(write_file_atomically(folder / "there/a.txt", "1"));
  std::filesystem::create_symlink(folder / "there/a.txt", folder / "link.txt");
  const auto calls = record([&] { EXPECT_TRUE(write_file_atomically(folder / "link.txt", "2")); });
  ASSERT_EQ(calls.size(), 3u);
  EXPECT_EQ(calls[1], "name a.txt");
  EXPECT_EQ(calls[2], "sync there");
}

TEST(DiskOrder, new_locked_file_syncs_content_then_renames_then_syncs_folder) {
  const test::TemporaryFolder folder;
  const auto calls = record([&] { EXPECT_TRUE(LockedFile::create(folder / "a.kerf", "head")); });
  ASSERT_EQ(calls.size(), 3u);
  EXPECT_TRUE(calls[0].starts_with("sync .a.kerf.")) << calls[0];
  EXPECT_EQ(calls[1], "name a.kerf");
  EXPECT_EQ(calls[2], "sync " + name_of(folder.path()));
}

}  // namespace
}  // namespace kerf
