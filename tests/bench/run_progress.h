#pragma once

#include <cstddef>
#include <string>

#include "tests/bench/timing.h"

namespace kerf::bench {

// Says on standard error which section of a run is being measured, which of its rows, and how much time has
// passed: in one line that is written over on a terminal, in a line for each row elsewhere.
class RunProgress {
 public:
  explicit RunProgress(size_t sections) : sections_(sections) {}

  // `what` names the section and its subject, `rows` is how many rows it has at most.
  void begin_section(const std::string& what, size_t rows);
  // Removes the line, so that a row of the table can be printed in its place.
  void clear() const;
  // The row was printed, the next one is being measured.
  void next_row();
  void end() const;

 private:
  void say() const;

  size_t sections_, section_ = 0, rows_ = 0, row_ = 0;
  std::string what_;
  double begun_ = passed_seconds();
};

}  // namespace kerf::bench
