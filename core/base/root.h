#pragma once

#include <algorithm>
#include <cmath>

namespace kerf {

// Finds where a function of [0, 1] changes its sign from at most zero to positive. Returns the upper end of
// an interval no longer than `precision`, or than the resolution of doubles, at whose lower end the function
// is at most zero and at whose upper end it is positive; an end of [0, 1] counts as such whatever its value.
// The method is that of I. Oliveira, R. Takahashi: An enhancement of the bisection method average performance
// preserving minmax optimality, 2020: about nine evaluations for a smooth function, and four more than
// bisection at worst.
//
// `at_0` and `at_1`: the values at the ends. `value(x, rest)` returns the value at x; no later x is farther
// from this one than `rest`. Precondition: precision > 0.
template <typename Value>
double upper_end_of_root(double at_0, double at_1, double precision, Value value) {
  constexpr double kShift = 0.1;  // how far estimates move towards the middle, per squared length
  constexpr int kMore = 4;        // evaluations more than those of bisection, at most
  double low = 0, high = 1, below = std::min(at_0, 0.0), above = std::max(at_1, 0.0);
  double slack = precision;  // the largest half of the interval's length from which bisection ends in time
  while (slack < 1 << (kMore - 1)) slack *= 2;
  for (; high - low > precision; slack *= 0.5) {
    const double length = high - low, middle = low + 0.5 * length;
    if (!(low < middle && middle < high)) break;
    const double slope = above - below, secant = slope > 0 ? low - length * (below / slope) : middle;
    const double shift =
        std::min(std::max(kShift * length * length, 0.5 * precision), std::abs(middle - secant));
    const double shifted = secant < middle ? secant + shift : secant - shift;
    const double reach = std::max(0.0, slack - 0.5 * length);
    double x = std::clamp(shifted, middle - reach, middle + reach);
    if (!(low < x && x < high)) x = middle;
    const double f = value(x, std::max(x - low, high - x));
    (f > 0 ? high : low) = x;
    (f > 0 ? above : below) = f;
  }
  return high;
}

}  // namespace kerf
