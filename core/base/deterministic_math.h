#pragma once

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "core/base/assert.h"
#include "core/base/geometry.h"

namespace kerf {

inline constexpr double kPi = std::numbers::pi;
constexpr double radians_of(double degrees) { return degrees * (kPi / 180); }
constexpr double degrees_of(double radians) { return radians * (180 / kPi); }

// Trigonometry with bit-identical results on every machine: only sums, products, quotients and square roots.
// Absolute errors are below 1e-12 for arguments of up to 1000 rad, and below 1e-9 up to 1e6 rad.
struct SinCos {
  double sin = 0, cos = 1;
};
SinCos sin_cos(double radians);
// Returns the angle of the vector (x, y) from the x axis, from -pi to pi; 0 for the zero vector.
namespace det {
double atan2(double y, double x);
}
// Wraps an angle to [-pi, pi]. Precondition: finite, with a magnitude below 1e9.
double wrapped(double radians);

// Returns the rotation about a unit axis by the right-hand rule.
glm::dquat axis_angle(const Vec3& axis, double radians);

// Directions in the game. A heading is an angle about +Y, 0 along +Z and positive to the left, towards +X; a
// pitch is the angle above the horizontal plane.
Vec3 direction_of(double heading, double pitch);
double heading_of(const Vec3& direction);
double pitch_of(const Vec3& direction);

namespace det {

// Returns e^x from sums and products alone, bit-identical on every machine. The relative error is below
// 1e-15. Precondition: x is from -700 to 700.
//
// Method: x = n ln 2 + r with |r| <= ln 2 / 2, e^r by its Taylor series, and 2^n by the bits of a double. ln
// 2 is the sum of two doubles, the first with so few digits that its product with n is exact (W. J. Cody, W.
// Waite: Software Manual for the Elementary Functions, 1980).
constexpr double exp(double x) {
  assert(x >= -700 && x <= 700);
  constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33;
  constexpr double kPerLn2 = 1.4426950408889634;
  constexpr int kTerms = 14;
  const double halves = x * kPerLn2;
  const auto n = static_cast<int64_t>(halves < 0 ? halves - 0.5 : halves + 0.5);
  const double r = (x - static_cast<double>(n) * kLn2High) - static_cast<double>(n) * kLn2Low;
  double sum = 1;
  for (int k = kTerms; k > 0; --k) sum = 1 + sum * r / k;
  return sum * std::bit_cast<double>(static_cast<uint64_t>(1023 + n) << 52);
}

// Returns the natural logarithm from sums, products and quotients alone, bit-identical on every machine. The
// error is below 1e-15 of the larger of 1 and the result. Precondition: x is a normal positive number.
//
// Method: x = 2^n m with m near 1, and ln m = 2 artanh((m - 1) / (m + 1)) by its series.
constexpr double log(double x) {
  assert(x >= 0x1p-1022 && x <= 0x1.fffffffffffffp1023);
  constexpr double kLn2 = 0.69314718055994531, kRoot2 = 1.4142135623730951;
  constexpr int kTerms = 11;
  const auto bits = std::bit_cast<uint64_t>(x);
  auto n = static_cast<int64_t>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0xfffffffffffffu) | (uint64_t{1023} << 52));
  if (m > kRoot2) {
    m *= 0.5;
    ++n;
  }
  const double s = (m - 1) / (m + 1), squared = s * s;
  double sum = 0;
  for (int k = kTerms; k >= 0; --k) sum = sum * squared + 1.0 / (2 * k + 1);
  return static_cast<double>(n) * kLn2 + 2 * s * sum;
}

}  // namespace det

// An order-independent sum of up to 2^32 numbers below 16 in absolute value. Each is truncated to kBits
// fractional bits; the sum of those is exact.
class FixedSum {
 public:
  void add(double x) {
    KERF_ASSERT(-16 < x && x < 16);
    const double high = x * 0x1p58;  // below 2^62
    const auto whole = static_cast<int64_t>(high);
    const auto rest = static_cast<int64_t>((high - static_cast<double>(whole)) * 0x1p32);
    sum_ += static_cast<Wide>(whole) * (int64_t{1} << 32) + rest;
  }
  // Returns the sum times 2^exponent.
  double value(int exponent) const { return std::ldexp(static_cast<double>(sum_), exponent - kBits); }

 private:
  __extension__ using Wide = __int128;
  static constexpr int kBits = 58 + 32;

  Wide sum_ = 0;
};

}  // namespace kerf
