#pragma once

#include <vector>

namespace kerf {

// How long frames took. Keeps the last million of them.
class FrameStatistics {
 public:
  void add(double milliseconds);
  size_t frames() const { return frames_; }
  // The value below which this share of the frames lies, nearest rank; 0 when there was none.
  double percentile(double share) const;
  double longest() const { return longest_; }
  // Those that are kept, while they are fewer than a million in the order in which they were.
  const std::vector<float>& each() const { return kept_; }
  double last() const { return last_; }

 private:
  std::vector<float> kept_;
  size_t frames_ = 0;
  double longest_ = 0, last_ = 0;
};

}  // namespace kerf
