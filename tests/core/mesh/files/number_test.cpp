#include "core/mesh/files/scanner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace kerf {
namespace {

TEST(Number, parses_common_notations) {
  EXPECT_EQ(parse_number("-1.5e-3"), -1.5e-3);
  EXPECT_EQ(parse_number("+2."), 2.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("1E2"), 100.0);
  EXPECT_TRUE(std::signbit(*parse_number("-0")));
  EXPECT_EQ(parse_number("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
}

TEST(Number, parses_all_spellings_of_nan_and_infinity) {
  for (const char* word :
       {"nan", "-nan", "NaN", "inf", "-Infinity", "+inf", "1.#IND", "-1.#INF", "1.#QNAN"}) {
    ASSERT_TRUE(parse_number(word)) << word;
    EXPECT_FALSE(std::isfinite(*parse_number(word))) << word;
  }
}

TEST(Number, overflows_to_infinity_and_underflows_to_zero) {
  EXPECT_EQ(parse_number("1e400"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number("-1e400"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number("1" + std::string(400, '0')), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number("1e99999999999999999999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number("1e-400"), 0.0);
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(parse_number("0e400"), 0.0);
}

TEST(Number, parses_a_garbled_number_as_nan_and_rejects_words) {
  EXPECT_TRUE(std::isnan(*parse_number("3.1+e2")));
  EXPECT_TRUE(std::isnan(*parse_number("1.2.3")));
  for (const char* word : {"", "-", "e", "abc", "3f", "0,5", "0x10", "nanometre", "1.0f"}) {
    EXPECT_FALSE(parse_number(word)) << word;
  }
}

TEST(Number, clamps_integers_to_64_bits) {
  EXPECT_EQ(parse_integer("-12"), -12);
  EXPECT_EQ(parse_integer("+7"), 7);
  EXPECT_EQ(parse_integer(std::string(1000, '9')), std::numeric_limits<int64_t>::max());
  EXPECT_EQ(parse_integer("-" + std::string(1000, '9')), std::numeric_limits<int64_t>::min());
  for (const char* word : {"", "-", "1.5", "3f", "one"}) EXPECT_FALSE(parse_integer(word)) << word;
}

}  // namespace
}  // namespace kerf
