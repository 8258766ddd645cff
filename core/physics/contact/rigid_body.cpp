#include "core/physics/contact/rigid_body.h"

#include <LinearMath/btMatrix3x3.h>

#include "core/world/body_mass.h"

namespace kerf {

namespace {

constexpr double kMinInertia = 1e-4;  // share of the largest one

// Sums over the pieces that are sheets, and the mass properties of the others.
struct Sums {
  double area = 0;
  AreaMoments moments;
  MassProperties solids;
};

Sums sums_of(const Body& body) {
  Sums sums;
  for (uint32_t p = 0; p < body.pieces.size(); ++p) {
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

// Computes the principal axes by Jacobi rotations.
void diagonalise(const glm::dmat3& inertia, RigidFrame& frame) {
  const auto& m = inertia;
  btMatrix3x3 matrix(m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]), turn;
  const double most = std::max({m[0][0], m[1][1], m[2][2]});
  matrix.diagonalize(turn, 1e-12 * most, 50);
  frame.inertia = {matrix[0][0], matrix[1][1], matrix[2][2]};
  btQuaternion q;
  turn.getRotation(q);
  frame.axes = glm::normalize(glm::dquat(q.w(), q.x(), q.y(), q.z()));
  frame.inertia = glm::max(frame.inertia, Vec3(kMinInertia * most));
}

}  // namespace

RigidFrame rigid_frame(const Body& body) {
  const MassProperties whole = mass_of(body);
  RigidFrame frame;
  frame.mass = whole.mass;
  frame.centre = whole.centre;
  if (whole.mass > 0) diagonalise(whole.inertia, frame);
  KERF_ASSERT(!(whole.mass > 0) || (frame.inertia.x > 0 && frame.inertia.y > 0 && frame.inertia.z > 0));
  return frame;
}

}  // namespace kerf
