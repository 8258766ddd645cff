#include "core/tree/sheared_ray.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "core/base/unit_vector.h"
#include "core/tree/ray_axes.h"

namespace kerf {

namespace {

__extension__ using Wide = unsigned __int128;

// A finite double, decomposed: sign * mantissa * 2^exponent with a mantissa of 53 bits, or zero.
struct Parts {
  int sign;
  int exponent;
  uint64_t mantissa;

  explicit Parts(double x) {
    assert(std::isfinite(x));
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

// The exact product of two doubles, with a mantissa of 106 bits.
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

// Rounding is monotonic: products that differ after rounding have the same order before it.
inline int sign_of_cross(Vec2 a, Vec2 b) {
  const double left = a.x * b.y, right = a.y * b.x;
  if (left != right) return left > right ? 1 : -1;
  return compare(Product(a.x, b.y), Product(a.y, b.x));
}

// Whether the ray passes to the left of a -> b. Ties are broken as if the ray were displaced by an
// infinitesimal amount towards +x and a smaller one towards +y.
inline bool is_left(Vec2 a, Vec2 b) {
  const double left = a.x * b.y, right = a.y * b.x;
  if (left != right) return left > right;
  const int side = sign_of_cross(a, b);
  if (side != 0) return side > 0;
  return a.y != b.y ? a.y > b.y : a.x < b.x;
}

// A sum that does not depend on the order of its arguments.
double sum_in_order(double a, double b, double c) {
  const double low = std::min(a, b), high = std::max(a, b);
  return (std::min(low, c) + std::max(high, c)) + std::max(low, std::min(high, c));
}

}  // namespace

int side_of(Vec2 a, Vec2 b) { return sign_of_cross(a, b); }

ShearedRay::ShearedRay(const Pose& ray) : origin_(ray.origin) {
  assert(is_unit(ray.direction));
  const Vec3 d = ray.direction, size = glm::abs(d);
  z_ = longest_axis(size.x, size.y, size.z);
  x_ = kNextAxis[z_];
  y_ = kNextAxis[x_];
  shear_ = {d[x_] / d[z_], d[y_] / d[z_]};
  per_z_ = 1.0 / d[z_];
}

std::optional<double> ShearedRay::cross(const Triangle& t) const {
  Vec2 p[3];
  double z[3];
  for (int i = 0; i < 3; ++i) {
    z[i] = t[i][z_] - origin_[z_];
    p[i] = {(t[i][x_] - origin_[x_]) - shear_.x * z[i], (t[i][y_] - origin_[y_]) - shear_.y * z[i]};
  }
  const int left = is_left(p[0], p[1]) + is_left(p[1], p[2]) + is_left(p[2], p[0]);
  if (left % 3 != 0) return std::nullopt;
  const double a = cross2(p[1], p[2]), b = cross2(p[2], p[0]), c = cross2(p[0], p[1]);
  const double sum = sum_in_order(a, b, c);
  // A triangle whose image is a single point is parallel to the ray. One whose image has an area that rounds
  // to zero is still crossed.
  if (p[0] == p[1] && p[1] == p[2]) return std::nullopt;
  if (sum == 0) return sum_in_order(z[0], z[1], z[2]) / 3 * per_z_;
  return sum_in_order(a * z[0], b * z[1], c * z[2]) / sum * per_z_;
}

}  // namespace kerf
