#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "core/base/assert.h"
#include "core/base/result.h"

namespace kerf {

// Progress reports of a long computation, and its cancellation. `report` is called on the thread of the
// computation, at most a thousand times per mesh, with a non-decreasing fraction of the work from 0 to 1.
// Once it returns false, it is not called again, and the computation soon fails with cancelled().
struct Progress {
  std::function<bool(double fraction)> report;
};

// Returns the progress of a part of the work, mapped to the fractions `low` to `high` of the whole. `whole`
// must outlive the result; if it is null, nothing is reported. Precondition: 0 <= low <= high.
inline Progress share_of(const Progress* whole, double low, double high) {
  KERF_ASSERT(0 <= low && low <= high);
  return {
      [whole, low, high](double fraction) { return !whole || whole->report(low + (high - low) * fraction); }};
}

// The error of a computation that the user cancelled: ErrorCode::kFailed, "cancelled".
inline Error cancelled() { return failed("cancelled"); }

// Reports the progress of a loop, at most kReports times; costs one decrement per item. `progress` may be
// null.
class Pace {
 public:
  static constexpr size_t kReports = 32;

  Pace(const Progress* progress, size_t items)
      : progress_(progress), items_(items), interval_(items / kReports + 1), left_(interval_) {}

  // Must be called after each item. Returns false if the loop should stop.
  bool step() { return --left_ > 0 || report(); }

 private:
  bool report() {
    left_ = interval_;
    reported_ += interval_;
    const double done = static_cast<double>(reported_) / static_cast<double>(items_);
    return !progress_ || progress_->report(std::min(1.0, done));
  }

  const Progress* progress_;
  size_t items_, interval_, left_;
  size_t reported_ = 0;  // items at the last report
};

// Divides progress among consecutive stages of a computation in proportion to their durations.
class ProgressShares {
 public:
  // `progress` may be null. It must outlive the results of next().
  explicit ProgressShares(const Progress* progress) : progress_(progress) {}

  // Returns the progress of the next stage. `share` is its fraction of the whole; all shares add up to 1.
  Progress next(double share) {
    KERF_ASSERT(share >= 0);
    const double low = std::exchange(done_, std::min(1.0, done_ + share));
    return share_of(progress_, low, done_);
  }

 private:
  const Progress* progress_;
  double done_ = 0;
};

// Multithreading by oneTBB. Used by loading, building, measuring, hashing, saving, simulation ticks and the
// heat of a cut, but not by finding, splitting, removing and separating faces. The division of the work does
// not depend on the number of threads, so that results combined by range are bit-identical.

// Calls work(begin, end) for the ranges [0, grain), [grain, 2 grain), ... of `items` items concurrently, and
// returns when all are done. Rethrows the first exception of `work`. Preconditions: grain > 0, and calls for
// different ranges write to different places.
using RangeWork = std::function<void(size_t begin, size_t end)>;
void for_each_range(size_t items, size_t grain, const RangeWork& work);

// Like for_each_range(), and reports progress between groups of ranges. Returns false if stopped, with some
// ranges left out. `progress` may be null.
bool for_each_range(size_t items, size_t grain, const Progress* progress, const RangeWork& work);

// Returns the number of ranges of for_each_range(). Precondition: grain > 0.
inline size_t range_count(size_t items, size_t grain) { return (items + grain - 1) / grain; }

// Calls both, concurrently if there are two threads, and returns when both are done.
void do_both(const std::function<void()>& first, const std::function<void()>& second);

// Runs the work with at most `threads` threads, 0 for one per processor, independently of concurrent calls;
// their floating-point modes are the caller's. Throws what the work throws.
void with_threads(size_t threads, const std::function<void()>& work);

// Returns the maximum number of concurrent threads.
size_t thread_count();

// Limits the number of threads during its lifetime; the lowest limit applies. Precondition: threads > 0.
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
