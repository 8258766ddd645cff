#pragma once

#include "core/base/vec3.h"

namespace kerf {

// A sum of squared distances from planes, each weighted by an area (M. Garland, P. S. Heckbert, 1997).
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  Vec3 linear{0};
  double constant = 0;
  double weight = 0;  // the sum of the areas

  // That of the plane of a triangle, weighted by its area; 0 for one without area.
  static Quadric of(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 cross = glm::cross(b - a, c - a);
    const double twice = glm::length(cross);
    if (!(twice > 0)) return {};
    const Vec3 n = cross / twice;
    const double d = -glm::dot(n, a), w = 0.5 * twice;
    return {w * n.x * n.x, w * n.x * n.y, w * n.x * n.z,
            w * n.y * n.y, w * n.y * n.z, w * n.z * n.z,
            w * d * n,     w * d * d,     w};
  }

  Quadric& operator+=(const Quadric& q) {
    xx += q.xx, xy += q.xy, xz += q.xz, yy += q.yy, yz += q.yz, zz += q.zz;
    linear += q.linear;
    constant += q.constant;
    weight += q.weight;
    return *this;
  }

  // The sum for a point, at least 0.
  double at(const Vec3& p) const {
    const double x = xx * p.x + xy * p.y + xz * p.z, y = xy * p.x + yy * p.y + yz * p.z,
                 z = xz * p.x + yz * p.y + zz * p.z;
    const double sum = p.x * x + p.y * y + p.z * z + 2 * glm::dot(linear, p) + constant;
    return sum > 0 ? sum : 0;
  }
};

}  // namespace kerf
