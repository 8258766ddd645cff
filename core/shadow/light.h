#pragma once

#include "core/base/geometry.h"

namespace kerf {

// A light in homogeneous coordinates: a position with w = 1, or with w = 0 the direction towards a light at
// infinity, of any length but zero. The frame depends on the context.
struct LightPoint {
  Vec3 xyz{0, 1, 0};
  double w = 0;
  friend bool operator==(const LightPoint&, const LightPoint&) = default;
};

struct Light {
  enum class Kind { kDirectional, kPoint };

  Kind kind = Kind::kDirectional;
  // In world coordinates. kDirectional: the direction to the light, of any length but zero; kPoint: its
  // position [m].
  Vec3 at{-0.42, 1.0, 0.62};
  Vec3 colour{1.0, 0.938, 0.848};  // linear RGB
  // Irradiance of a surface that faces the light, relative to the display's white; 2.1 is a bright key light.
  // For a point light it holds at a distance of one diagonal of the world and falls off with the squared
  // distance.
  double intensity = 2.1;

  // Returns the light in homogeneous world coordinates.
  LightPoint point() const { return {at, kind == Kind::kPoint ? 1.0 : 0.0}; }
  friend bool operator==(const Light&, const Light&) = default;
};

}  // namespace kerf
