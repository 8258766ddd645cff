#pragma once

#include "core/world/shell_mass.h"

namespace kerf {

// Moments of the volume that some triangles enclose: the integrals of 1, of x and of x x^T, where x is the
// position relative to a fixed origin. They are signed sums of the tetrahedra between the origin and each
// triangle, and so they mean something only where the triangles are closed (see closed_pieces). The origin
// should lie near the middle of the triangles (see AreaMoments).
struct VolumeMoments {
  double volume = 0;               // m^3
  Vec3 first{0};                   // m^4
  std::array<double, 6> second{};  // m^5: xx, yy, zz, xy, xz, yz

  VolumeMoments& operator+=(const VolumeMoments& other);
  friend bool operator==(const VolumeMoments&, const VolumeMoments&) = default;
};

// The share of one triangle, exact but for rounding: with corners p, q, r relative to the origin, the signed
// volume v = p . (q x r) / 6 and s = p + q + r it is v, v / 4 * s and v / 20 * (p p^T + q q^T + r r^T + s
// s^T).
VolumeMoments volume_moments(const Triangle& t, const Vec3& origin);

// Mass properties of a solid body from the sums over the triangles around it, relative to `origin`. The
// density is positive (kg/m^3). What encloses no volume, as far as rounding can tell (volume <= 0), has no
// mass and its centre at the origin. Constant time.
MassProperties solid_mass(const VolumeMoments& moments, const Vec3& origin, double density);

// Mass properties of two bodies that move as one. Those of the first are returned as they are where the
// second has no mass, and the other way round.
MassProperties together(const MassProperties& a, const MassProperties& b);

// What is known of the volume of a piece of a solid body since the body was weighed. It holds as long as the
// piece has as many faces as then and their area to the bit; other pieces are open, as far as is known.
struct EnclosedPiece {
  MassProperties solid;  // of density 1, in the frame of the body
  size_t faces = 0;
  double area = 0;  // m^2
};

}  // namespace kerf
