#include "tests/bench/run_progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace kerf::bench {

namespace {

bool on_terminal() { return isatty(STDERR_FILENO) == 1; }

}  // namespace

void RunProgress::begin_section(const std::string& what, size_t rows) {
  what_ = what;
  rows_ = rows;
  row_ = 1;
  ++section_;
  say();
}

void RunProgress::clear() const {
  if (on_terminal()) std::fputs("\r\033[K", stderr);
}

void RunProgress::next_row() {
  row_ = std::min(row_ + 1, rows_);
  say();
}

void RunProgress::end() const {
  clear();
  std::fprintf(stderr, "%zu sections in %.0f s\n", section_, passed_seconds() - begun_);
}

void RunProgress::say() const {
  clear();
  std::fprintf(stderr, "section %zu of %zu, %s: row %zu of at most %zu, %.0f s%s", section_, sections_,
               what_.c_str(), row_, rows_, passed_seconds() - begun_, on_terminal() ? "" : "\n");
}

}  // namespace kerf::bench
