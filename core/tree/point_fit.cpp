#include "core/tree/point_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>

#include "core/base/assert.h"

namespace kerf {

namespace {

using PointPairs = std::span<const std::pair<Vec3, Vec3>>;

std::pair<Vec3, Vec3> centres(PointPairs pairs) {
  Vec3 a(0), b(0);
  for (const auto& [from, to] : pairs) {
    a += from;
    b += to;
  }
  return {a / static_cast<double>(pairs.size()), b / static_cast<double>(pairs.size())};
}

// Returns the eigenvector of the largest eigenvalue in magnitude, by repeated squaring.
glm::dvec4 largest_eigenvector(glm::dmat4 m) {
  constexpr int kSquarings = 60;
  for (int i = 0; i < kSquarings; ++i) {
    double largest = 0;
    for (int k = 0; k < 4; ++k) {
      for (int n = 0; n < 4; ++n) largest = std::max(largest, std::abs(m[k][n]));
    }
    m /= largest;
    m = m * m;
  }
  int column = 0;
  for (int k = 1; k < 4; ++k) {
    if (m[k][k] > m[column][column]) column = k;
  }
  return glm::normalize(m[column]);
}

}  // namespace

bool determine_motion(std::span<const std::pair<Vec3, Vec3>> pairs) {
  constexpr double kNarrowest = 1e-3;  // width of the points, as a share of their length
  if (pairs.size() < 3) return false;
  const auto spread = [&](auto at) {
    Vec3 longest(0);
    for (const auto& pair : pairs) {
      const Vec3 way = at(pair) - at(pairs[0]);
      if (glm::dot(way, way) > glm::dot(longest, longest)) longest = way;
    }
    const double length2 = glm::dot(longest, longest);
    return length2 > 0 && std::ranges::any_of(pairs, [&](const auto& pair) {
             return glm::length(glm::cross(at(pair) - at(pairs[0]), longest)) > kNarrowest * length2;
           });
  };
  return spread([](const auto& pair) { return pair.first; }) &&
         spread([](const auto& pair) { return pair.second; });
}

RigidMotion fit_points(std::span<const std::pair<Vec3, Vec3>> pairs) {
  KERF_ASSERT(determine_motion(pairs));
  const auto [from, to] = centres(pairs);
  glm::dmat3 s(0.0);  // s[k][n]: coordinate n of the first points times coordinate k of the second ones
  double size = 0;
  for (const auto& [a, b] : pairs) {
    s += glm::outerProduct(a - from, b - to);
    size += glm::length(a - from) * glm::length(b - to);
  }
  const auto sum = [&](int a, int b) { return s[b][a]; };
  glm::dmat4 n(0.0);
  const double yz = sum(1, 2) - sum(2, 1), zx = sum(2, 0) - sum(0, 2), xy = sum(0, 1) - sum(1, 0);
  n[0] = {sum(0, 0) + sum(1, 1) + sum(2, 2), yz, zx, xy};
  n[1] = {yz, sum(0, 0) - sum(1, 1) - sum(2, 2), sum(0, 1) + sum(1, 0), sum(2, 0) + sum(0, 2)};
  n[2] = {zx, sum(0, 1) + sum(1, 0), sum(1, 1) - sum(0, 0) - sum(2, 2), sum(1, 2) + sum(2, 1)};
  n[3] = {xy, sum(2, 0) + sum(0, 2), sum(1, 2) + sum(2, 1), sum(2, 2) - sum(0, 0) - sum(1, 1)};
  // All eigenvalues lie within -size .. size, so those of the shifted matrix are not negative.
  const glm::dvec4 q = largest_eigenvector(n + glm::dmat4(size));
  RigidMotion motion;
  motion.rotation = glm::dquat(q[0], q[1], q[2], q[3]);
  motion.translation = to - motion.rotation * from;
  return motion;
}

}  // namespace kerf
