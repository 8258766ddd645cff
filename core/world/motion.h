#pragma once

#include <cstdint>
#include <glm/geometric.hpp>

#include "core/base/vec3.h"
#include "core/heat/substance.h"
#include "core/world/placement.h"

namespace kerf {

// The rigid motion of a body in world axes. The velocity is that of the point of the body that lies at the
// origin of its frame, i.e. at Placement::position: so it stays what it is when a cut moves the centre of
// mass, and a piece that is detached inherits its motion by a copy.
struct Motion {
  Vec3 velocity{0};    // m/s
  Vec3 spin{0};        // rad/s
  uint32_t quiet = 0;  // ticks for which the body was slow enough to fall asleep
  bool asleep = false;

  friend bool operator==(const Motion&, const Motion&) = default;

  bool at_rest() const { return velocity == Vec3(0) && spin == Vec3(0); }
  void wake() {
    quiet = 0;
    asleep = false;
  }
  // The velocity of the point of the body that is at p in the world, m/s.
  Vec3 velocity_at(const Vec3& p, const Placement& placement) const {
    return velocity + glm::cross(spin, p - placement.position);
  }
};

// The sheet that the faces of a body stand for. Precondition of its use: thickness and density are positive.
struct Sheet {
  double thickness = 0.001;  // m
  double density =
      7850;             // kg/m^3, of mild steel; what the body weighs (vehicles are given their weight by it)
  Substance substance;  // the material, which tells how it is heated and cut
  friend bool operator==(const Sheet&, const Sheet&) = default;
};

}  // namespace kerf
