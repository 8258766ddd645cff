#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/world/world.h"

namespace kerf {

// What a ray meets.
struct SightHit {
  BodyId body;           // not valid for the ground
  double length = 0;     // m, along the ray
  Vec3 normal{0, 1, 0};  // unit, in the world, against the ray
};

// Answers what rays meet in a world, which must not change meanwhile: neither bodies nor their faces. Keeps a
// sphere around every visible body to pass over most of them.
class Sight {
 public:
  explicit Sight(const World& world);

  // Whether a body stops a ray.
  using Stops = std::function<bool(BodyId)>;

  // The first thing that a ray meets within a length, the ground among them. Precondition: the direction is a
  // unit vector.
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

// Whether a half-line of a length comes as near to a sphere as `reach` metres.
bool comes_near(const Pose& ray, double length, const Vec3& centre, double radius, double reach = 0);

}  // namespace kerf
