#pragma once

#include <optional>

#include "core/tree/swept_cylinder.h"

namespace kerf {

// A ray in coordinates in which it runs along +z: an axis is exchanged and the others sheared (S. Woop,
// C. Benthin, I. Wald: Watertight ray/triangle intersection, 2013). A corner has the same image in every
// face, and on which side of an edge of images the ray passes is decided exactly, ties by rule
// (H. Edelsbrunner, E. Mücke: Simulation of simplicity, 1990), so a closed surface is crossed an even number
// of times wherever the ray goes through it.
class ShearedRay {
 public:
  ShearedRay() = default;
  // The direction is not zero.
  explicit ShearedRay(const Pose& ray);
  // The same for a ray of equal direction.
  ShearedRay beside(const Pose& ray) const {
    ShearedRay other = *this;
    other.origin_ = ray.origin;
    return other;
  }

  // Length along the unit direction at which the ray crosses the triangle, however its corners are turned;
  // nothing where it passes beside it or along it.
  std::optional<double> cross(const Triangle& t) const;

 private:
  Vec3 origin_{0};
  Vec2 shear_{0};
  double per_z_ = 1;
  int x_ = 0, y_ = 1, z_ = 2;
};

// Whether a.x * b.y > a.y * b.x (1), less (-1) or equal (0), exactly, for finite numbers.
int side_of(Vec2 a, Vec2 b);

}  // namespace kerf
