#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "core/base/assert.h"
#include "core/base/result.h"

namespace kerf {

// How a long computation reports its progress and learns whether to go on. `report` is called on the thread
// of the computation, at most a thousand times per mesh, with a fraction of the work from 0 to 1 that never
// decreases. Once it returns false it is not called again, and the computation stops as soon as it can with
// the error cancelled().
struct Progress {
  std::function<bool(double fraction)> report;
};

// The progress of a part of the work, mapped to the fractions `low` to `high` of the whole. `whole` must
// outlive the result; it may be null, in which case nothing is reported. Precondition: 0 <= low <= high.
inline Progress share_of(const Progress* whole, double low, double high) {
  KERF_ASSERT(0 <= low && low <= high);
  return {
      [whole, low, high](double fraction) { return !whole || whole->report(low + (high - low) * fraction); }};
}

// The error of a computation that the user stopped: ErrorCode::kFailed, "cancelled".
inline Error cancelled() { return failed("cancelled"); }

// Reports the progress of a loop over `items` items, at most kReports times; costs one decrement per item.
// `progress` may be null.
class Pace {
 public:
  static constexpr size_t kReports = 32;

  Pace(const Progress* progress, size_t items)
      : progress_(progress), items_(items), every_(items / kReports + 1), left_(every_) {}

  // To be called after each item. Returns whether the loop should go on.
  bool step() { return --left_ > 0 || tell(); }

 private:
  bool tell() {
    left_ = every_;
    told_ += every_;
    const double done = static_cast<double>(told_) / static_cast<double>(items_);
    return !progress_ || progress_->report(std::min(1.0, done));
  }

  const Progress* progress_;
  size_t items_, every_, left_;
  size_t told_ = 0;  // items at the last report
};

// Divides a progress among consecutive stages of a computation in proportion to the time that they take.
class ProgressShares {
 public:
  // `progress` may be null. It must outlive what next() returns.
  explicit ProgressShares(const Progress* progress) : progress_(progress) {}

  // The progress of the next stage. `share` is its fraction of the whole; all shares add up to 1.
  Progress next(double share) {
    KERF_ASSERT(share >= 0);
    const double low = std::exchange(done_, std::min(1.0, done_ + share));
    return share_of(progress_, low, done_);
  }

 private:
  const Progress* progress_;
  double done_ = 0;
};

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
