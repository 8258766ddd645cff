#pragma once

#include <optional>

#include "core/tree/swept_cylinder.h"

namespace kerf {

// A watertight ray-triangle test. Axes are permuted and sheared so that the ray becomes the z axis (S. Woop,
// C. Benthin, I. Wald: Watertight ray/triangle intersection, 2013). A corner has the same image in every face
// that it belongs to, the side of an edge on which the ray passes is decided exactly, and ties are broken by
// symbolic perturbation (H. Edelsbrunner, E. Mücke: Simulation of simplicity, 1990). A ray from outside
// therefore crosses a closed surface an even number of times, also through edges and corners.
class ShearedRay {
 public:
  ShearedRay() = default;
  // Precondition: the direction is a unit vector.
  explicit ShearedRay(const Pose& ray);
  // Makes the sheared ray of a parallel ray. Precondition: its direction equals that of this ray.
  ShearedRay beside(const Pose& ray) const {
    ShearedRay other = *this;
    other.origin_ = ray.origin;
    return other;
  }

  // The length along the ray, in metres, at which its line crosses the triangle, whatever the orientation of
  // the triangle; nothing if it misses the triangle or is parallel to it. The length may be negative.
  std::optional<double> cross(const Triangle& t) const;

 private:
  Vec3 origin_{0};
  Vec2 shear_{0};
  double per_z_ = 1;
  int x_ = 0, y_ = 1, z_ = 2;
};

// The exact sign (1, 0 or -1) of a.x * b.y - a.y * b.x. Precondition: all coordinates are finite.
int side_of(Vec2 a, Vec2 b);

}  // namespace kerf
