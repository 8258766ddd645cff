#pragma once

#include <glm/mat3x3.hpp>

#include "core/physics/collider.h"
#include "core/physics/rigid_frame.h"

namespace kerf {

// A rigid motion x -> turn * x + shift.
struct RigidMap {
  glm::dmat3 turn{1.0};
  Vec3 shift{0};
  Vec3 operator()(const Vec3& p) const { return turn * p + shift; }
};

inline RigidMap map_of(const Placement& placement) {
  return {glm::mat3_cast(placement.orientation), placement.position};
}
// First `inner`, then the reverse of `outer`.
inline RigidMap into(const RigidMap& outer, const RigidMap& inner) {
  const glm::dmat3 back = glm::transpose(outer.turn);
  return {back * inner.turn, back * (inner.shift - outer.shift)};
}

// A body during a tick.
struct MovingBody {
  BodyId id;
  Body* body = nullptr;
  const Collider* collider = nullptr;
  RigidFrame frame;
  bool fixed = false;  // it does not move
  bool asleep = false;
  RigidMap now, next;   // body to world: where it is, and where it will be if nothing stops it
  Vec3 min{0}, max{0};  // m, bounds in the world of its way with its reach
  double scale = 1;     // of all lengths of contact, see ContactLengths
};

// Lengths of contact, for bodies of about a metre and more. Smaller bodies use smaller ones, in proportion.
struct ContactLengths {
  double skin = 0.002;          // m, kept between a point and a face
  double chord_skin = 0.001;    // between two chords
  double ground_skin = 0.001;   // between a point and the ground
  double reach = 0.010;         // how far apart contacts are found
  double chord_memory = 0.030;  // how far apart the sides of chords are remembered
};

}  // namespace kerf
