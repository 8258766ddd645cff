#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/cut/cut_step.h"

namespace kerf {

// What the last steps took and changed, and what the last pictures sent: numbers to be drawn as lines.
class StepChart {
 public:
  enum Line { kFind, kRefine, kRemove, kTree, kSeparate, kBorn, kGone, kSent, kLines };
  static constexpr size_t kKept = 240;

  void note_step(const StepResult& step);  // milliseconds and faces
  void note_sent(size_t bytes);            // of one picture, kilobytes

  // Oldest first.
  std::span<const float> line(Line line) const { return lines_[line]; }
  float last(Line line) const { return lines_[line].empty() ? 0 : lines_[line].back(); }
  float largest(Line line) const;

 private:
  void add(Line line, double value);
  std::array<std::vector<float>, kLines> lines_;
};

// Memory that this process holds, bytes; 0 where that cannot be found out.
size_t process_bytes();

}  // namespace kerf
