#include "core/base/deterministic_math.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace kerf::test {
namespace {

TEST(Exponential, has_a_relative_error_below_1e_minus_15) {
  Random random(5);
  for (int i = 0; i < 100000; ++i) {
    const double x = i % 2 == 0 ? random.uniform(-700, 700) : random.uniform(-1, 1);
    EXPECT_NEAR(det::exp(x) / std::exp(x), 1, 1e-15) << x;
  }
}

TEST(Logarithm, inverts_the_exponential) {
  Random random(6);
  for (int i = 0; i < 100000; ++i) {
    const double x = std::exp(random.uniform(-700, 700));
    EXPECT_NEAR(det::log(x), std::log(x), 1e-15 * std::max(1.0, std::abs(std::log(x)))) << x;
  }
  EXPECT_EQ(det::log(1), 0);
}

TEST(Exponential, of_zero_is_one) { EXPECT_EQ(det::exp(0), 1); }

}  // namespace
}  // namespace kerf::test
