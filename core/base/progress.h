#pragma once

#include <functional>

#include "core/base/result.h"

namespace kerf {

// How long work tells how far it is (0 to 1, never less than before) and asks whether to go on. `report` is
// called a few hundred times at most, on the thread that works; when it returns false the work stops as soon
// as it can and ends with ErrorCode::kFailed, "cancelled".
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

}  // namespace kerf
