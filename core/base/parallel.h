#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "core/base/progress.h"

namespace kerf {

// Work on several threads, by oneTBB. Loading, building, measuring, hashing and saving use it, and ticks and
// heat beside a cut; finding, splitting, removing and separating do not. How the work is divided never
// depends on the number of threads, so that results which are put together range by range have the same bits
// with any number.

// Calls work(begin, end) for the ranges [0, grain), [grain, 2 grain), ... of `items` items, several at a
// time, and returns when all are done. The first exception that `work` throws is thrown here. Preconditions:
// grain > 0, and calls for different ranges write to different places.
using RangeWork = std::function<void(size_t begin, size_t end)>;
void for_each_range(size_t items, size_t grain, const RangeWork& work);

// Does the work of for_each_range() and reports progress between groups of ranges. Returns false if it was
// stopped, with some ranges left out. `progress` may be null.
bool for_each_range(size_t items, size_t grain, const Progress* progress, const RangeWork& work);

// The number of ranges that for_each_range() makes. Precondition: grain > 0.
inline size_t range_count(size_t items, size_t grain) { return (items + grain - 1) / grain; }

// Calls both, at the same time where there are two threads, and returns when both are done.
void do_both(const std::function<void()>& first, const std::function<void()>& second);

// Does the work with at most so many threads, 0 for as many as there are processors, whatever other calls use
// at the same time; their floating-point modes are those of the caller. Throws what the work throws.
void with_threads(size_t threads, const std::function<void()>& work);

// The number of threads that work at the same time at most.
size_t thread_count();

// Limits the number of threads while it exists; of several limits the least counts. Precondition: threads >
// 0.
class ThreadLimit {
 public:
  explicit ThreadLimit(size_t threads);
  ~ThreadLimit();
  ThreadLimit(ThreadLimit&&) noexcept;
  ThreadLimit& operator=(ThreadLimit&&) noexcept;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace kerf
