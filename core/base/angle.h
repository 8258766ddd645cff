#pragma once

#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "core/base/vec3.h"

namespace kerf {

inline constexpr double kPi = std::numbers::pi;
constexpr double radians_of(double degrees) { return degrees * (kPi / 180); }
constexpr double degrees_of(double radians) { return radians * (180 / kPi); }

// Trigonometry that gives the same bits on every machine: only sums, products, quotients and square roots.
// Absolute errors are below 1e-12 for arguments of up to 1e6 rad.
struct SinCos {
  double sin = 0, cos = 1;
};
SinCos sin_cos(double radians);
// The angle of the vector (x, y) against the x axis, from -pi to pi; 0 for the zero vector.
double arc_tangent(double y, double x);
// An angle, brought to between -pi and pi by full turns. Precondition: finite and below 1e9.
double wrapped(double radians);

// The rotation about a unit axis by the right-hand rule.
glm::dquat turn_about(const Vec3& axis, double radians);

// Directions of the game: a heading is an angle about +Y, 0 along +Z and positive to the left, towards +X;
// a pitch is the angle above the horizontal plane.
Vec3 direction_of(double heading, double pitch);
double heading_of(const Vec3& direction);
double pitch_of(const Vec3& direction);

}  // namespace kerf
