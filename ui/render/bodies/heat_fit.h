#pragma once

#include <array>
#include <span>

#include "core/base/vec3.h"

namespace kerf {

// What a face at a vertex knows of its heat: its mean temperatures, now and the highest ones that were, which
// are those at its centroid.
struct FaceSample {
  Vec3 centroid;
  double size;                           // its longest edge (m)
  std::array<double, 2> temperatures{};  // K
};

// A temperature at a vertex (K) and its gradient there (K/m).
struct LocalHeat {
  double at = 0;
  Vec3 gradient{0};
};

// Fits temperatures that are linear in space to the faces around a vertex. The mean of a few faces of
// different sizes would be the temperature of another place than the vertex. Least squares, weighted by one
// over the fourth power of the size of the face, since the mean of a large face says little of what lies near
// one of its corners. Where the centroids leave a direction open, the gradient has no part in it.
// Preconditions: there are samples, and none has the size 0.
std::array<LocalHeat, 2> fit_heat(const Vec3& vertex, std::span<const FaceSample> samples);

}  // namespace kerf
