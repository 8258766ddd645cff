#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace kerf {
namespace {

TEST(Parallel, ranges_cover_every_item_once_for_any_thread_count) {
  for (const size_t threads : {1, 2, 16}) {
    const ThreadLimit limit(threads);
    for (const size_t items : {0, 1, 6, 7, 8, 1000}) {
      std::vector<int> visits(items);
      for_each_range(items, 7, [&](size_t begin, size_t end) {
        EXPECT_EQ(begin % 7, 0u);
        EXPECT_LE(end - begin, 7u);
        for (size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(items, 1));
    }
  }
}

TEST(Parallel, reports_increasing_progress_on_the_calling_thread) {
  const auto here = std::this_thread::get_id();
  double last = 0;
  const Progress progress{[&](double fraction) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  }};
  EXPECT_TRUE(for_each_range(10000, 3, &progress, [](size_t, size_t) {}));
  EXPECT_EQ(last, 1);
}

TEST(Parallel, stops_when_the_progress_callback_cancels) {
  std::atomic<size_t> done = 0;
  const Progress progress{[](double) { return false; }};
  EXPECT_FALSE(for_each_range(100000, 1, &progress, [&](size_t, size_t) { ++done; }));
  EXPECT_LT(done, 100000u);
}

TEST(Parallel, propagates_exceptions_of_the_work_to_the_caller) {
  EXPECT_THROW(for_each_range(100, 1,
                              [](size_t i, size_t) {
                                if (i == 50) throw std::runtime_error("here");
                              }),
               std::runtime_error);
}

TEST(Parallel, the_smallest_thread_limit_applies_until_it_is_destroyed) {
  const size_t before = thread_count();
  {
    const ThreadLimit three(3);
    const ThreadLimit two(2);
    EXPECT_EQ(thread_count(), 2u);
  }
  EXPECT_EQ(thread_count(), before);
}

}  // namespace
}  // namespace kerf
