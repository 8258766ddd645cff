#pragma once

#include <functional>

namespace kerf {

// How long work tells how far it is (0 to 1, never less than before) and asks whether to go on. `report` is
// called a few hundred times at most, on the thread that works; when it returns false the work stops as soon
// as it can and ends with ErrorCode::kFailed, "cancelled".
struct Progress {
  std::function<bool(double fraction)> report;
};

}  // namespace kerf
