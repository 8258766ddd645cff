#include "core/base/principal_axes.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;  // rows

constexpr int kSweeps = 12;  // of Jacobi's method, which converges quadratically

Matrix3 covariance(std::span<const Vec3> points, const Vec3& mean) {
  Matrix3 sum{};
  for (const Vec3& p : points) {
    const Vec3 d = p - mean;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) sum[static_cast<size_t>(i)][static_cast<size_t>(k)] += d[i] * d[k];
    }
  }
  return sum;
}

// One rotation of Jacobi's method: zeroes m[p][q] and rotates the columns of `axes` accordingly.
void rotate(Matrix3& m, Matrix3& axes, size_t p, size_t q) {
  if (m[p][q] == 0) return;
  const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (size_t k = 0; k < 3; ++k) {
    const double a = m[k][p], b = m[k][q];
    m[k][p] = c * a - s * b;
    m[k][q] = s * a + c * b;
  }
  for (size_t k = 0; k < 3; ++k) {
    const double a = m[p][k], b = m[q][k];
    m[p][k] = c * a - s * b;
    m[q][k] = s * a + c * b;
  }
  for (size_t k = 0; k < 3; ++k) {
    const double a = axes[k][p], b = axes[k][q];
    axes[k][p] = c * a - s * b;
    axes[k][q] = s * a + c * b;
  }
}

}  // namespace

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 mean(0);
  for (size_t i = 0; i < points.size(); ++i) mean += (points[i] - mean) / static_cast<double>(i + 1);
  return mean;
}

std::array<Vec3, 3> principal_axes(std::span<const Vec3> points, const Vec3& mean) {
  Matrix3 m = covariance(points, mean);
  Matrix3 axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rotate(m, axes, 0, 1);
    rotate(m, axes, 0, 2);
    rotate(m, axes, 1, 2);
  }
  std::array<size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return m[a][a] > m[b][b]; });
  std::array<Vec3, 3> directions;
  for (size_t i = 0; i < 3; ++i) {
    Vec3 v(axes[0][order[i]], axes[1][order[i]], axes[2][order[i]]);
    double largest = v.x;
    for (const double c : {v.y, v.z}) {
      if (std::abs(c) > std::abs(largest)) largest = c;
    }
    directions[i] = largest < 0 ? -v : v;
  }
  return directions;
}

}  // namespace kerf
