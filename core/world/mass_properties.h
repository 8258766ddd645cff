#pragma once

#include <array>
#include <glm/mat3x3.hpp>

#include "core/mesh/mesh.h"

namespace kerf {

// First and second moments of area of some triangles: the integrals of x and of x x^T over their surface,
// where x is the position relative to a fixed origin. Together with the area these ten sums give mass, centre
// and inertia of a thin shell, and they can be added and subtracted face by face. Rounding errors grow with
// the distance from the origin (as (distance / remaining size)^4), so the origin should lie near the middle
// of the mesh.
struct AreaMoments {
  Vec3 first{0};                   // m^3
  std::array<double, 6> second{};  // m^4: xx, yy, zz, xy, xz, yz

  AreaMoments& operator+=(const AreaMoments& other);
  AreaMoments& operator-=(const AreaMoments& other);
  friend bool operator==(const AreaMoments&, const AreaMoments&) = default;
};

// Returns the moments of one triangle of the given area (m^2; triangle_area(t)), exact but for rounding: with
// corners p, q, r relative to the origin and s = p + q + r they are area / 3 * s and area / 12 * (p p^T + q
// q^T + r r^T + s s^T).
AreaMoments area_moments(const Triangle& t, double area, const Vec3& origin);

struct MassProperties {
  double mass = 0;          // kg
  Vec3 centre{0};           // m, of mass
  glm::dmat3 inertia{0.0};  // kg m^2, about the centre, along the axes of the frame of the triangles
};

// Returns the mass properties of a thin shell. `area` and `moments` are the sums over its faces, relative to
// `origin`; thickness in m, density in kg/m^3, both positive. A shell without area up to rounding (area <= 0)
// has no mass and its centre at the origin. O(1).
MassProperties shell_mass(double area, const AreaMoments& moments, const Vec3& origin, double thickness,
                          double density);

// Moments of the volume that some triangles enclose: the integrals of 1, of x and of x x^T, where x is the
// position relative to a fixed origin. They are signed sums over the tetrahedra between the origin and each
// triangle, and meaningful only for closed triangles (see closed_pieces). The origin should lie near the
// middle of the triangles (see AreaMoments).
struct VolumeMoments {
  double volume = 0;               // m^3
  Vec3 first{0};                   // m^4
  std::array<double, 6> second{};  // m^5: xx, yy, zz, xy, xz, yz

  VolumeMoments& operator+=(const VolumeMoments& other);
  friend bool operator==(const VolumeMoments&, const VolumeMoments&) = default;
};

// Returns the contribution of one triangle, exact but for rounding: with corners p, q, r relative to the
// origin, the signed volume v = p . (q x r) / 6 and s = p + q + r it is v, v / 4 * s and v / 20 * (p p^T + q
// q^T + r r^T + s s^T).
VolumeMoments volume_moments(const Triangle& t, const Vec3& origin);

// Returns the mass properties of a solid body from the sums over its triangles, relative to `origin`. The
// density is positive (kg/m^3). Without a volume up to rounding (volume <= 0) the mass is 0 and the centre is
// at the origin. O(1).
MassProperties solid_mass(const VolumeMoments& moments, const Vec3& origin, double density);

// Returns the mass properties of two bodies that move as one; those of one if the other has no mass.
MassProperties combine(const MassProperties& a, const MassProperties& b);

// The volume of a piece of a solid body when it was last computed. It is valid while the piece has the same
// number of faces and, to the bit, their area; other pieces count as open.
struct EnclosedPiece {
  MassProperties solid;  // of density 1, in the frame of the body
  size_t faces = 0;
  double area = 0;  // m^2
};

}  // namespace kerf
