#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/ids.h"

namespace kerf {

// A number for each face slot of a body.
using FaceScalars = std::vector<float>;
// Of faces that have no number; slots behind the last one have none either.
inline constexpr float kNoScalar = std::numeric_limits<float>::max();

// Numbers of faces that colour the bodies instead of their paints: those from `low` to `high` through
// scalar_colour(), those beyond as the ends, and grey what has none.
struct ScalarField {
  std::map<BodyId, std::shared_ptr<const FaceScalars>> of_bodies;  // not null
  float low = 0, high = 1;                                         // low < high
  std::string name;                                                // with the unit, for the legend
  std::array<std::string, 5> labels;  // of numbers evenly spaced from `low` to `high`
};

// A colour of the scale, t = 0 .. 1, from dark violet over blue and green to pale yellow: linear light, or
// sRGB. Equal steps of t look equally large.
glm::dvec3 linear_scalar_colour(double t);
glm::vec3 scalar_colour(double t);

}  // namespace kerf
