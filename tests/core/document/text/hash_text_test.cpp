#include "core/document/text/hash.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace kerf {
namespace {

TEST(HashText, sixteen_hex_digits_round_trip) {
  EXPECT_EQ(hash_text(0x0123456789abcdef), "0123456789abcdef");
  EXPECT_EQ(hash_text(0), "0000000000000000");
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const uint64_t hash = random.bits() >> random.below(64);
    EXPECT_EQ(hash_text(hash).size(), 16u);
    EXPECT_EQ(parse_hash(hash_text(hash)), hash);
  }
}

TEST(HashText, upper_case_digits_are_accepted) {
  EXPECT_EQ(parse_hash("0123456789ABCDEF"), uint64_t{0x0123456789abcdef});
  EXPECT_EQ(parse_hash("fFfFfFfFfFfFfFfF"), ~uint64_t{0});
}

TEST(HashText, rejects_any_other_text) {
  for (const char* text : {"", "123456789abcdef", "00123456789abcdef", "0123456789abcdeg", "0123456789abcde ",
                           " 123456789abcdef", "0x23456789abcdef", "-123456789abcdef", "+123456789abcdef",
                           "-123456789ABCDEF", "0X23456789ABCDEF", "0123456789ABCDEG"})
    EXPECT_FALSE(parse_hash(text)) << text;
}

}  // namespace
}  // namespace kerf
