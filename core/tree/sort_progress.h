#pragma once

#include <atomic>
#include <cstddef>
#include <thread>

#include "core/base/progress.h"

namespace kerf {

// The progress of sorting faces into a tree on several threads; only the thread that made it reports. Sorting
// a range of n faces takes time in proportion to n log2 n, so a split accounts for the difference between the
// range and its two parts.
class SortProgress {
 public:
  // `progress` may be null; it must outlive this object.
  SortProgress(const Progress* progress, size_t faces);

  void note_split(size_t whole, size_t left, size_t right);
  void note_done(size_t faces);
  bool stopped() const { return stopped_; }

 private:
  void note(double done);

  const Progress* progress_;
  std::thread::id owner_;
  double all_;
  double next_ = 0;  // the work after which the owner reports again
  std::atomic<double> done_ = 0;
  std::atomic<bool> stopped_ = false;
};

}  // namespace kerf
