#include "core/base/deterministic_math.h"

namespace kerf {

namespace {

int64_t rounded(double x) { return static_cast<int64_t>(x < 0 ? x - 0.5 : x + 0.5); }

// Taylor series for |x| <= pi / 4.
double sine_near_zero(double x) {
  double term = x, sum = x;
  for (int n = 3; n <= 17; n += 2) {
    term *= -x * x / (n * (n - 1));
    sum += term;
  }
  return sum;
}

double cosine_near_zero(double x) {
  double term = 1, sum = 1;
  for (int n = 2; n <= 18; n += 2) {
    term *= -x * x / (n * (n - 1));
    sum += term;
  }
  return sum;
}

// Precondition: 0 <= t <= 1. Halving the angle twice leaves at most 0.2, where the series converges quickly.
double arc_tangent_of_ratio(double t) {
  for (int halving = 0; halving < 2; ++halving) t = t / (1 + std::sqrt(1 + t * t));
  double power = t, sum = t;
  for (int n = 3; n <= 17; n += 2) {
    power *= -t * t;
    sum += power / n;
  }
  return 4 * sum;
}

}  // namespace

SinCos sin_cos(double radians) {
  const int64_t quarter = rounded(radians / (kPi / 2));
  const double rest = radians - static_cast<double>(quarter) * (kPi / 2);
  const double s = sine_near_zero(rest), c = cosine_near_zero(rest);
  switch (quarter & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double det::atan2(double y, double x) {
  const double a = std::abs(x), b = std::abs(y);
  if (a == 0 && b == 0) return 0;
  double angle = a >= b ? arc_tangent_of_ratio(b / a) : kPi / 2 - arc_tangent_of_ratio(a / b);
  if (x < 0) angle = kPi - angle;
  return y < 0 ? -angle : angle;
}

double wrapped(double radians) {
  KERF_ASSERT(std::abs(radians) < 1e9);
  return radians - static_cast<double>(rounded(radians / (2 * kPi))) * (2 * kPi);
}

glm::dquat axis_angle(const Vec3& axis, double radians) {
  const SinCos half = sin_cos(0.5 * radians);
  return {half.cos, half.sin * axis};
}

Vec3 direction_of(double heading, double pitch) {
  const SinCos h = sin_cos(heading), p = sin_cos(pitch);
  return {p.cos * h.sin, p.sin, p.cos * h.cos};
}

double heading_of(const Vec3& direction) { return det::atan2(direction.x, direction.z); }

double pitch_of(const Vec3& direction) {
  const double across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  return det::atan2(direction.y, across);
}

}  // namespace kerf
