#pragma once

#include <span>
#include <utility>

#include "core/tree/surface_comparison.h"

namespace kerf {

// Returns true if the first points of some pairs, and the second ones, determine a rigid motion: they do not
// lie on one line.
bool determine_motion(std::span<const std::pair<Vec3, Vec3>> pairs);

// Returns the motion from the first to the second points that minimises the sum of the squared distances. The
// rotation is the eigenvector of the largest eigenvalue of a symmetric matrix (B. K. P. Horn: Closed-form
// solution of absolute orientation using unit quaternions, 1987). Precondition: determine_motion().
RigidMotion fit_points(std::span<const std::pair<Vec3, Vec3>> pairs);

}  // namespace kerf
