#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/assert.h"

namespace kerf {

// A sum of up to 2^32 numbers below 16 in absolute value. Each is cut off kBits bits after the point; the sum
// is exact, so that it does not depend on their order.
class FixedSum {
 public:
  void add(double x) {
    KERF_ASSERT(-16 < x && x < 16);
    const double high = x * 0x1p58;  // below 2^62
    const auto whole = static_cast<int64_t>(high);
    const auto rest = static_cast<int64_t>((high - static_cast<double>(whole)) * 0x1p32);
    sum_ += static_cast<Wide>(whole) * (int64_t{1} << 32) + rest;
  }
  // The sum times 2^exponent.
  double value(int exponent) const { return std::ldexp(static_cast<double>(sum_), exponent - kBits); }

 private:
  __extension__ using Wide = __int128;
  static constexpr int kBits = 58 + 32;

  Wide sum_ = 0;
};

}  // namespace kerf
