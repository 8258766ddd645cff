#include "core/base/ids.h"

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

TEST(Tick, is_a_hundred_and_twentieth_of_a_second) {
  EXPECT_EQ(seconds_of_ticks(120), 1.0);
  EXPECT_EQ(seconds_of_ticks(60), 0.5);
}

}  // namespace
}  // namespace kerf::test
