#pragma once

#include <array>
#include <glm/mat3x3.hpp>

#include "core/mesh/mesh.h"

namespace kerf {

// First and second moments of area of some triangles: the integrals of x and of x x^T over their surface,
// where x is the position relative to a fixed origin. Together with the area these ten sums give mass, centre
// and inertia of a thin shell, and they can be added and subtracted face by face. Rounding errors grow with
// the distance from the origin (to the fourth power of distance / size of what is left), so the origin
// should lie near the middle of the mesh.
struct AreaMoments {
  Vec3 first{0};                   // m^3
  std::array<double, 6> second{};  // m^4: xx, yy, zz, xy, xz, yz

  AreaMoments& operator+=(const AreaMoments& other);
  AreaMoments& operator-=(const AreaMoments& other);
  friend bool operator==(const AreaMoments&, const AreaMoments&) = default;
};

// The moments of one triangle of the given area (m^2; triangle_area(t)), exact but for rounding: with
// corners p, q, r relative to the origin and s = p + q + r they are area / 3 * s and
// area / 12 * (p p^T + q q^T + r r^T + s s^T).
AreaMoments area_moments(const Triangle& t, double area, const Vec3& origin);

// Mass properties of a rigid body.
struct MassProperties {
  double mass = 0;          // kg
  Vec3 centre{0};           // m, of mass
  glm::dmat3 inertia{0.0};  // kg m^2, about the centre, along the axes of the frame of the triangles
};

// Mass properties of a shell that is thin compared with its size. `area` and `moments` are the sums over its
// faces, relative to `origin`; thickness in m, density in kg/m^3, both positive. A shell without area, as far
// as rounding can tell (area <= 0), has no mass and its centre at the origin. Constant time.
MassProperties shell_mass(double area, const AreaMoments& moments, const Vec3& origin, double thickness,
                          double density);

}  // namespace kerf
