#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/world/world.h"

namespace kerf {

struct SightHit {
  BodyId body;           // invalid for the ground
  double length = 0;     // m, along the ray
  Vec3 normal{0, 1, 0};  // unit, in the world, against the ray
};

// Casts rays in a world, of which neither bodies nor faces may change in the meantime. Keeps a sphere
// around every visible body to skip most of them.
class Sight {
 public:
  explicit Sight(const World& world);

  using Stops = std::function<bool(BodyId)>;

  // The first hit of a ray within a length, including the ground. Precondition: the direction is a unit
  // vector.
  std::optional<SightHit> nearest(const Pose& ray, double length, const Stops& stops) const;

  // A body whose faces may be near a beam.
  struct Near {
    BodyId id;
    const Body* body;
    Vec3 centre;    // m, of a sphere around its faces, in the world
    double radius;  // m
  };
  const std::vector<Near>& bodies() const { return bodies_; }

 private:
  const World& world_;
  std::vector<Near> bodies_;
};

// Returns true if a segment of this length [m] comes within `reach` [m] of a sphere.
bool passes_near(const Pose& ray, double length, const Vec3& centre, double radius, double reach = 0);

}  // namespace kerf
