#include "ui/editor/shared/statistics/frame_statistics.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {
constexpr size_t kKept = 1'000'000;
}

void FrameStatistics::add(double milliseconds) {
  if (kept_.size() < kKept) {
    kept_.push_back(static_cast<float>(milliseconds));
  } else {
    kept_[frames_ % kKept] = static_cast<float>(milliseconds);
  }
  ++frames_;
  longest_ = std::max(longest_, milliseconds);
  last_ = milliseconds;
}

double FrameStatistics::percentile(double share) const {
  KERF_ASSERT(share >= 0 && share <= 1);
  if (kept_.empty()) return 0;
  std::vector<float> sorted = kept_;
  const double rank = std::ceil(share * static_cast<double>(sorted.size())) - 1;
  const auto index = static_cast<size_t>(std::clamp(rank, 0.0, static_cast<double>(sorted.size() - 1)));
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(index), sorted.end());
  return sorted[index];
}

}  // namespace kerf
