#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
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

}  // namespace kerf
