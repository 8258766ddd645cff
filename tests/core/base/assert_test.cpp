#include "core/base/assert.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/environment.h"

namespace kerf::test {
namespace {

TEST(Assert, evaluates_its_condition_once_and_prints_nothing_if_it_holds) {
  int evaluated = 0;
  testing::internal::CaptureStderr();
  KERF_ASSERT(++evaluated == 1);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(evaluated, 1);
}

TEST(Assert, reports_each_failing_place_once_and_continues_if_not_fatal) {
  const EnvironmentVariable asserts("KERF_ASSERTS", nullptr);
  testing::internal::CaptureStderr();
  for (int i = 0; i < 3; ++i) KERF_ASSERT(i < 0);
  const std::string output = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1);
  EXPECT_NE(output.find("i < 0"), std::string::npos);
  EXPECT_NE(output.find("assert_test.cpp:"), std::string::npos);
}

TEST(AssertDeathTest, aborts_if_the_environment_variable_is_set) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const EnvironmentVariable asserts("KERF_ASSERTS", "fatal");
  EXPECT_DEATH(KERF_ASSERT(1 + 1 == 3), "assertion failed: 1 \\+ 1 == 3");
}

}  // namespace
}  // namespace kerf::test
