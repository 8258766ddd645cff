#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/cut/cut_step.h"

namespace kerf {

// The durations and changes of the last steps and the bytes sent for the last pictures, as lines of a chart.
class StepChart {
 public:
  enum Line { kFind, kRefine, kRemove, kTree, kSeparate, kBorn, kGone, kSent, kLines };
  static constexpr size_t kKept = 240;

  void note_step(const StepResult& step);  // milliseconds and faces
  void note_sent(size_t bytes);            // of one picture, kilobytes

  // The values of a line, oldest first.
  std::span<const float> line(Line line) const { return lines_[line]; }
  float last(Line line) const { return lines_[line].empty() ? 0 : lines_[line].back(); }
  float largest(Line line) const;

 private:
  void add(Line line, double value);
  std::array<std::vector<float>, kLines> lines_;
};

// The memory used by this process in bytes, or 0 if that is unknown.
size_t process_bytes();

}  // namespace kerf
