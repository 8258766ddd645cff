#include "core/base/task.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

Task<int> sum_to(int n, std::string& log) {
  int sum = 0;
  for (int i = 1; i <= n; ++i) {
    sum += i;
    log += std::to_string(i);
    co_await yield_after(kPartOfWork / 2);
  }
  co_return sum;
}

Task<std::unique_ptr<int>> sum_of_both(int a, int b, std::string& log) {
  const int first = co_await sum_to(a, log);
  log += '+';
  const int second = co_await sum_to(b, log);
  co_return std::make_unique<int>(first + second);
}

TEST(Task, splits_nested_tasks_into_slices_of_equal_work) {
  std::string log;
  auto sum = sum_of_both(3, 2, log);
  EXPECT_EQ(log, "");
  EXPECT_FALSE(sum.resume());
  EXPECT_EQ(log, "12");
  EXPECT_FALSE(sum.resume());
  EXPECT_EQ(log, "123+1");
  EXPECT_TRUE(sum.resume());
  EXPECT_EQ(log, "123+12");
  EXPECT_EQ(*sum.take(), 9);
}

TEST(Task, returns_the_same_result_when_run_to_completion) {
  std::string log;
  EXPECT_EQ(*run_to_completion(sum_of_both(4, 5, log)), 25);
  EXPECT_EQ(log, "1234+12345");
}

TEST(Task, can_be_moved_and_destroyed_at_any_time) {
  const auto count = std::make_shared<int>(0);
  const auto counts = [](std::shared_ptr<int> own) -> Task<int> {
    for (;;) {
      ++*own;
      co_await yield_after(kPartOfWork);
    }
  };
  {
    auto never_begun = counts(count);
    auto begun = counts(count);
    EXPECT_FALSE(begun.resume());
    auto moved = std::move(begun);
    EXPECT_FALSE(moved.resume());
    EXPECT_EQ(*count, 2);
  }
  EXPECT_EQ(count.use_count(), 1);
}

Task<int> throws_later() {
  co_await yield_after(kPartOfWork);
  throw std::runtime_error("later");
}

Task<int> waits_for_what_throws() { co_return co_await throws_later(); }

TEST(Task, propagates_exceptions) {
  auto computation = waits_for_what_throws();
  EXPECT_FALSE(computation.resume());
  EXPECT_THROW(computation.resume(), std::runtime_error);
}

}  // namespace
}  // namespace kerf
