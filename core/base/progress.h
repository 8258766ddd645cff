#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "core/base/result.h"

namespace kerf {

// How long work tells how far it is (0 to 1, never less than before) and asks whether to go on. `report` is
// called a thousand times a mesh at most, on the thread that works; when it returns false it is not called
// again, and the work stops as soon as it can and ends with ErrorCode::kFailed, "cancelled".
struct Progress {
  std::function<bool(double fraction)> report;
};

// The progress of a part of the work, from `low` to `high` of the whole, which must outlive it; one that
// nobody listens to where there is no whole.
inline Progress share_of(const Progress* whole, double low, double high) {
  return {
      [whole, low, high](double fraction) { return !whole || whole->report(low + (high - low) * fraction); }};
}

// The error of work that the user stopped.
inline Error cancelled() { return failed("cancelled"); }

// Tells how far a loop over so many items is, up to kReports times, and costs a decrement an item. `progress`
// may be null.
class Pace {
 public:
  static constexpr size_t kReports = 32;

  Pace(const Progress* progress, size_t items)
      : progress_(progress), items_(items), every_(items / kReports + 1), left_(every_) {}

  // After each item: whether to go on.
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
  size_t told_ = 0;  // items
};

// The parts of a piece of work, one after the other, in shares of the time that they take.
class Stages {
 public:
  // `progress`, which may be null, must outlive what next() gives.
  explicit Stages(const Progress* progress) : progress_(progress) {}

  // The progress of the next part, which takes so much of the whole.
  Progress next(double share) {
    const double low = std::exchange(done_, std::min(1.0, done_ + share));
    return share_of(progress_, low, done_);
  }

 private:
  const Progress* progress_;
  double done_ = 0;
};

}  // namespace kerf
