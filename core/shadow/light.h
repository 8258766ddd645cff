#pragma once

#include "core/base/vec3.h"

namespace kerf {

// A light as a homogeneous point of some frame: a position with w = 1, or with w = 0 the direction towards a
// light that is infinitely far away (any length but zero).
struct LightPoint {
  Vec3 xyz{0, 1, 0};
  double w = 0;
  friend bool operator==(const LightPoint&, const LightPoint&) = default;
};

// A light of a world.
struct Light {
  enum class Kind { kDirectional, kPoint };

  Kind kind = Kind::kDirectional;
  // kDirectional: the direction towards the light, of any length but zero; kPoint: where it stands, m. The
  // axes of the world.
  Vec3 at{-0.42, 1.0, 0.62};
  Vec3 colour{1.0, 0.938, 0.848};  // linear RGB
  // What a surface that faces the light receives, 2.1 for a bright key light. From a point light at a
  // distance of one diagonal of the world; it falls off with the square of the distance.
  double intensity = 2.1;

  LightPoint point() const { return {at, kind == Kind::kPoint ? 1.0 : 0.0}; }
  friend bool operator==(const Light&, const Light&) = default;
};

}  // namespace kerf
