#include "core/tree/sheared_ray.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace kerf {

namespace {

__extension__ using Wide = unsigned __int128;

// A finite double apart: sign * mantissa * 2^exponent, the mantissa of 53 bits, or zero.
struct Parts {
  int sign;
  int exponent;
  uint64_t mantissa;

  explicit Parts(double x) {
    const auto bits = std::bit_cast<uint64_t>(x);
    const int field = static_cast<int>(bits >> 52 & 0x7ff);
    mantissa = (bits & 0xfffffffffffffu) | (field != 0 ? uint64_t{1} << 52 : 0);
    exponent = field != 0 ? field : 1;
    sign = mantissa == 0 ? 0 : (x < 0 ? -1 : 1);
    if (mantissa == 0) return;
    const int shift = std::countl_zero(mantissa) - 11;
    mantissa <<= shift;
    exponent -= shift;
  }
};

// A product of two doubles, exactly: its mantissa has 106 bits or 105.
struct Product {
  int sign;
  int exponent;
  Wide mantissa;

  Product(double a, double b) {
    const Parts p(a), q(b);
    sign = p.sign * q.sign;
    exponent = p.exponent + q.exponent;
    mantissa = Wide{p.mantissa} * q.mantissa;
    if (sign != 0 && (mantissa >> 105) == 0) {
      mantissa <<= 1;
      --exponent;
    }
  }
};

int compare(const Product& a, const Product& b) {
  if (a.sign != b.sign) return a.sign > b.sign ? 1 : -1;
  if (a.sign == 0) return 0;
  if (a.exponent != b.exponent) return (a.exponent > b.exponent) == (a.sign > 0) ? 1 : -1;
  if (a.mantissa != b.mantissa) return (a.mantissa > b.mantissa) == (a.sign > 0) ? 1 : -1;
  return 0;
}

// Whether the ray passes left of a -> b. A tie is settled as if the ray stood a hair towards +x, and less
// towards +y.
bool is_left(Vec2 a, Vec2 b) {
  const int side = side_of(a, b);
  if (side != 0) return side > 0;
  return a.y != b.y ? a.y > b.y : a.x < b.x;
}

bool before(const Vec3& a, const Vec3& b) {
  return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : a.z < b.z);
}

}  // namespace

// Rounding keeps order, so that products which differ after rounding differ the same way before it.
int side_of(Vec2 a, Vec2 b) {
  const double left = a.x * b.y, right = a.y * b.x;
  if (left != right) return left > right ? 1 : -1;
  return compare(Product(a.x, b.y), Product(a.y, b.x));
}

ShearedRay::ShearedRay(const Pose& ray) : origin_(ray.origin) {
  const Vec3 d = ray.direction, size = glm::abs(d);
  z_ = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  shear_ = {d[x_] / d[z_], d[y_] / d[z_]};
  per_z_ = 1.0 / d[z_];
}

std::optional<double> ShearedRay::cross(const Triangle& t) const {
  Vec2 p[3];
  double z[3];
  // From the least corner on, so that the length does not depend on where the turn starts.
  int corner = before(t[0], t[1]) ? (before(t[0], t[2]) ? 0 : 2) : (before(t[1], t[2]) ? 1 : 2);
  for (int i = 0; i < 3; ++i, corner = corner == 2 ? 0 : corner + 1) {
    const Vec3 v = t[corner] - origin_;
    p[i] = {v[x_] - shear_.x * v[z_], v[y_] - shear_.y * v[z_]};
    z[i] = v[z_];
  }
  const bool left = is_left(p[0], p[1]);
  if (is_left(p[1], p[2]) != left || is_left(p[2], p[0]) != left) return std::nullopt;
  const double a = cross2(p[1], p[2]), b = cross2(p[2], p[0]), c = cross2(p[0], p[1]), sum = a + b + c;
  // A triangle so thin that its area is rounded away is crossed all the same.
  if (sum == 0) return (z[0] + z[1] + z[2]) / 3 * per_z_;
  return (a * z[0] + b * z[1] + c * z[2]) / sum * per_z_;
}

}  // namespace kerf
