#pragma once

#include <cstddef>
#include <vector>

namespace kerf {

// The durations of frames. The last million of them are kept.
class FrameStatistics {
 public:
  void add(double milliseconds);
  size_t frames() const { return frames_; }
  // The percentile of the durations for a fraction 0 .. 1, by nearest rank; 0 without frames.
  double percentile(double share) const;
  double longest() const { return longest_; }
  // The durations kept, in their order as long as they are fewer than a million.
  const std::vector<float>& each() const { return kept_; }
  double last() const { return last_; }

 private:
  std::vector<float> kept_;
  size_t frames_ = 0;
  double longest_ = 0, last_ = 0;
};

}  // namespace kerf
