#include "core/document/text/hash.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

TEST(FileHash, changes_with_each_byte_and_with_the_length) {
  test::TemporaryFolder folder;
  const auto hash = [&](const std::string& bytes) {
    test::write_text(folder / "file", bytes);
    return *file_hash(folder / "file");
  };
  const std::string bytes((1 << 20) + 300, 'a');
  std::set<uint64_t> hashes{hash(bytes), hash(""), hash("a"), hash(std::string(1, '\0')),
                            hash(std::string(2, '\0'))};
  for (const size_t at : {size_t{0}, size_t{7}, size_t{1 << 20}, bytes.size() - 1}) {
    std::string other = bytes;
    other[at] = 'b';
    hashes.insert(hash(other));
  }
  EXPECT_EQ(hashes.size(), 9u);
  EXPECT_EQ(hash(bytes), hash(bytes));
}

TEST(FileHash, names_a_missing_file_or_a_folder_in_the_error) {
  test::TemporaryFolder folder;
  const auto missing = file_hash(folder / "gone.obj");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("gone.obj"), std::string::npos) << missing.error().message;
  EXPECT_FALSE(file_hash(folder.path()));
}

TEST(FileHash, can_be_cancelled) {
  test::TemporaryFolder folder;
  test::write_text(folder / "file", std::string(3 << 20, 'a'));
  const Progress stopped{[](double) { return false; }};
  const auto hash = file_hash(folder / "file", &stopped);
  ASSERT_FALSE(hash);
  EXPECT_EQ(hash.error().message, cancelled().message);
}

}  // namespace
}  // namespace kerf
