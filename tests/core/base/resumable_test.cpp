#include "core/base/task.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

Resumable<int> sum_to(int n, std::string& log) {
  int sum = 0;
  for (int i = 1; i <= n; ++i) {
    sum += i;
    log += std::to_string(i);
    co_await worked(kPartOfWork / 2);
  }
  co_return sum;
}

Resumable<std::unique_ptr<int>> sum_of_both(int a, int b, std::string& log) {
  const int first = co_await sum_to(a, log);
  log += '+';
  const int second = co_await sum_to(b, log);
  co_return std::make_unique<int>(first + second);
}

TEST(Resumable, does_parts_of_equal_work_across_nested_computations) {
  std::string log;
  auto sum = sum_of_both(3, 2, log);
  EXPECT_EQ(log, "");
  EXPECT_FALSE(sum.go_on());
  EXPECT_EQ(log, "12");
  EXPECT_FALSE(sum.go_on());
  EXPECT_EQ(log, "123+1");
  EXPECT_TRUE(sum.go_on());
  EXPECT_EQ(log, "123+12");
  EXPECT_EQ(*sum.take(), 9);
}

TEST(Resumable, is_the_same_at_once) {
  std::string log;
  EXPECT_EQ(*at_once(sum_of_both(4, 5, log)), 25);
  EXPECT_EQ(log, "1234+12345");
}

TEST(Resumable, can_be_moved_and_given_up_at_any_time) {
  const auto count = std::make_shared<int>(0);
  const auto counts = [](std::shared_ptr<int> own) -> Resumable<int> {
    for (;;) {
      ++*own;
      co_await worked(kPartOfWork);
    }
  };
  {
    auto never_begun = counts(count);
    auto begun = counts(count);
    EXPECT_FALSE(begun.go_on());
    auto moved = std::move(begun);
    EXPECT_FALSE(moved.go_on());
    EXPECT_EQ(*count, 2);
  }
  EXPECT_EQ(count.use_count(), 1);
}

Resumable<int> throws_later() {
  co_await worked(kPartOfWork);
  throw std::runtime_error("later");
}

Resumable<int> waits_for_what_throws() { co_return co_await throws_later(); }

TEST(Resumable, lets_exceptions_out) {
  auto computation = waits_for_what_throws();
  EXPECT_FALSE(computation.go_on());
  EXPECT_THROW(computation.go_on(), std::runtime_error);
}

}  // namespace
}  // namespace kerf
