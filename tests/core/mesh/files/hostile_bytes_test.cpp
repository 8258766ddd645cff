// Damaged files of every format give a mesh or a one-line error.

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/core/mesh/files/sample_files.h"

namespace kerf {
namespace {

using test::Sample;

void expect_result_or_one_line(const Sample& sample, const std::string& bytes, const std::string& what) {
  // A copy with nothing after it, so that the sanitizers detect a read past the end.
  const std::vector<char> exact(bytes.begin(), bytes.end());
  const Result<Soup> soup =
      test::reader_of(sample.format)({exact.data(), exact.size()}, sample.name, nullptr);
  if (!soup) {
    EXPECT_TRUE(test::is_one_line_about(soup.error(), sample.name)) << what << ": " << soup.error().message;
    return;
  }
  EXPECT_EQ(soup->triangles_in_file, soup->triangles.size() + soup->invalid_faces_dropped) << what;
  for (const auto& triangle : soup->triangles) {
    for (const uint32_t v : triangle) ASSERT_LT(v, soup->positions.size()) << what;
  }
}

std::string mutated(std::string bytes, Random& random) {
  static const std::vector<std::string> kWords{
      "-1",   "4294967295",           "1e999", "nan", "#", "\\\n", " ", "\n",
      "\r\n", "99999999999999999999", "/",     "f",   "",  "-",    ",", "\xff"};
  const uint64_t edits = 1 + random.below(4);
  for (uint64_t i = 0; i < edits; ++i) {
    const size_t at = random.below(bytes.size() + 1);
    const size_t length = random.below(std::min<size_t>(8, bytes.size() - at) + 1);
    switch (random.below(3)) {
      case 0:
        bytes.replace(at, length, kWords[random.below(kWords.size())]);
        break;
      case 1:
        bytes.replace(at, length, std::string(length, static_cast<char>(random.below(256))));
        break;
      default:
        bytes.insert(at, bytes, random.below(bytes.size() + 1), random.below(40));
    }
  }
  return bytes;
}

TEST(HostileBytes, valid_samples_read_as_one_square) {
  for (const Sample& sample : test::sample_files()) {
    const Result<Soup> soup = test::reader_of(sample.format)(sample.bytes, sample.name, nullptr);
    ASSERT_TRUE(soup) << soup.error().message;
    EXPECT_EQ(soup->triangles.size(), 2u) << sample.name;
    EXPECT_EQ(test::area(*soup), 1.0) << sample.name;
    EXPECT_EQ(soup->format, format_row(sample.format).ending);
  }
}

TEST(HostileBytes, a_file_truncated_at_any_byte_fails_cleanly) {
  for (const Sample& sample : test::sample_files()) {
    for (size_t n = 0; n < sample.bytes.size(); ++n) {
      expect_result_or_one_line(sample, sample.bytes.substr(0, n),
                                sample.name + (" cut at " + std::to_string(n)));
    }
  }
}

TEST(HostileBytes, a_truncated_file_with_counts_is_never_accepted_as_complete) {
  for (const Sample& sample : test::sample_files()) {
    if (sample.format == MeshFormat::kObj) continue;
    // The last line end, and in text the digits before it, may be missing.
    for (size_t n = 0; n + 20 < sample.bytes.size(); ++n) {
      const auto soup = test::reader_of(sample.format)(sample.bytes.substr(0, n), sample.name, nullptr);
      if (!soup) continue;
      // An STL may end after a facet, with a warning.
      EXPECT_EQ(sample.format, MeshFormat::kStl) << sample.name << " cut at " << n;
      EXPECT_EQ(soup->warnings.size(), 1u) << sample.name << " cut at " << n;
    }
  }
}

TEST(HostileBytes, changed_bytes_fail_cleanly) {
  const uint64_t seed = 20240611;
  RecordProperty("seed", std::to_string(seed));
  Random random(seed);
  for (const Sample& sample : test::sample_files()) {
    for (int i = 0; i < 3000; ++i) {
      const std::string bytes = mutated(sample.bytes, random);
      expect_result_or_one_line(
          sample, bytes, sample.name + (", seed " + std::to_string(seed) + ", mutant " + std::to_string(i)));
    }
  }
}

TEST(HostileBytes, every_reader_handles_random_bytes) {
  Random random(7);
  for (const Sample& sample : test::sample_files()) {
    for (int i = 0; i < 300; ++i) {
      std::string bytes(random.below(400), ' ');
      for (char& c : bytes) c = static_cast<char>(random.below(256));
      expect_result_or_one_line(sample, bytes, "random bytes");
    }
  }
}

}  // namespace
}  // namespace kerf
