#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace kerf::bench {

// How many of a smaller unit a second has.
inline constexpr double kMilli = 1e3, kMicro = 1e6, kNano = 1e9;

// Seconds of processor time that this process has used.
inline double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Seconds that have passed, for work that is done on several threads.
inline double passed_seconds() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

using Clock = double (*)();

template <typename Work>
double seconds_of(Work&& work, Clock clock = cpu_seconds) {
  const double start = clock();
  work();
  return clock() - start;
}

// Returns the value below which this share of the values lies. Precondition: there are values.
inline double quantile(std::vector<double> values, double share) {
  const auto rank = static_cast<size_t>(share * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<long>(std::min(rank, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}
inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

// Medians of two kinds of work that are done in turn, so that what else the machine does falls on both.
struct Pair {
  double ours = 0, peer = 0;
};
template <typename Ours, typename Peer>
Pair in_turn(int times, Ours&& ours, Peer&& peer, Clock clock = cpu_seconds) {
  std::vector<double> a, b;
  for (int i = 0; i < times; ++i) {
    a.push_back(seconds_of(ours, clock));
    b.push_back(seconds_of(peer, clock));
  }
  return {median(a), median(b)};
}

}  // namespace kerf::bench
