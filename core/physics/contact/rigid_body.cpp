#include "core/physics/contact/rigid_body.h"

#include <LinearMath/btMatrix3x3.h>
#include <algorithm>
#include <cmath>

#include "core/world/body_mass.h"

namespace kerf {

namespace {

constexpr double kMinInertia = 1e-4;    // share of the largest one
constexpr double kCoarseInertia = 1e6;  // kg m^2, above which the tolerance of the axes does not grow

// Sums over the pieces that are sheets, and the mass properties of the others.
struct Sums {
  double area = 0;
  AreaMoments moments;
  MassProperties solids;
};

Sums sums_of(const Body& body) {
  Sums sums;
  for (uint32_t p = 0; p < body.pieces.size(); ++p) {
    if (body.pieces[p].faces == 0) continue;  // rounding may have left it an area
    if (const EnclosedPiece* enclosed = enclosed_piece(body, p)) {
      MassProperties solid = enclosed->solid;
      solid.mass *= body.sheet.density;
      solid.inertia *= body.sheet.density;
      sums.solids = combine(sums.solids, solid);
    } else {
      sums.area += body.pieces[p].area;
      sums.moments += body.pieces[p].moments;
    }
  }
  return sums;
}

MassProperties mass_of(const Body& body) {
  const Sums sums = sums_of(body);
  const MassProperties shell =
      shell_mass(sums.area, sums.moments, body.middle(), body.sheet.thickness, body.sheet.density);
  return combine(shell, sums.solids);
}

// Returns the inertia of a body with these bounds. Sums about the middle of the loaded body do not resolve
// the inertia of a remnant less than a millionth of its size; what they yield may be negative. Such a remnant
// gets the inertia of a cuboid. No inertia of a mass within the bounds exceeds the mass times the squared
// diagonal, nor do principal moments violate the triangle inequality.
glm::dmat3 resolved_inertia(const MassProperties& whole, const Bounds& bounds) {
  constexpr double kNoise = 0.01;  // tolerance of the triangle inequality
  const auto& m = whole.inertia;
  const double largest = std::max({m[0][0], m[1][1], m[2][2]}), trace = m[0][0] + m[1][1] + m[2][2];
  const Vec3 size = bounds.max - bounds.min, squares = size * size;
  const double diagonal2 = glm::dot(size, size);
  if (largest > 0 && largest <= whole.mass * diagonal2 && 2 * largest <= (1 + kNoise) * trace) return m;
  glm::dmat3 cuboid(0.0);
  for (int k = 0; k < 3; ++k) cuboid[k][k] = whole.mass / 12 * (diagonal2 - squares[k]);
  return cuboid;
}

// Computes the principal axes by Jacobi rotations. Bullet's tolerance is relative to the trace, so it must
// stay far below 1.
void diagonalise(const glm::dmat3& inertia, RigidFrame& frame) {
  const auto& m = inertia;
  btMatrix3x3 matrix(m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]), turn;
  const double largest = std::max({m[0][0], m[1][1], m[2][2]});
  matrix.diagonalize(turn, 1e-12 * std::min(largest, kCoarseInertia), 50);
  frame.inertia = {matrix[0][0], matrix[1][1], matrix[2][2]};
  btQuaternion q;
  turn.getRotation(q);
  frame.axes = glm::normalize(glm::dquat(q.w(), q.x(), q.y(), q.z()));
  frame.inertia = glm::max(frame.inertia, Vec3(kMinInertia * largest));
}

// Returns true if the moments and their inverses are finite and positive.
bool is_usable(const Vec3& inertia) {
  const auto usable = [](double moment) { return std::isnormal(moment) && moment > 0; };
  return usable(inertia.x) && usable(inertia.y) && usable(inertia.z);
}

}  // namespace

RigidFrame rigid_frame(const Body& body) {
  const MassProperties whole = mass_of(body);
  RigidFrame frame;
  frame.mass = whole.mass;
  frame.centre = whole.centre;
  if (whole.mass > 0) diagonalise(resolved_inertia(whole, body.bounds()), frame);
  if (!is_usable(frame.inertia)) frame.mass = 0;
  return frame;
}

}  // namespace kerf
