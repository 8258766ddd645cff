#pragma once

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <span>

#include "core/base/assert.h"
#include "core/physics/contact/collider.h"
#include "core/world/world.h"

namespace kerf {

// Mass properties of a body and its principal frame: centre of mass and principal axes of inertia.
struct RigidFrame {
  double mass = 0;              // kg
  Vec3 centre{0};               // in the body frame [m]
  glm::dquat axes{1, 0, 0, 0};  // rotates principal axes to those of the body
  Vec3 inertia{0};              // along the principal axes [kg m^2]

  // Returns the placement of the principal frame for a placement of the body.
  Placement in_world(const Placement& body) const { return {body.to_world(centre), body.orientation * axes}; }
  // Returns the placement of the body, with normalised orientation, for a placement of the principal frame.
  Placement body_at(const Placement& principal) const {
    const glm::dquat turn = glm::normalize(principal.orientation * glm::conjugate(axes));
    return {principal.position - turn * centre, turn};
  }
};

// Returns the rigid frame of all pieces of a body together. Closed pieces of a solid body count as solids, as
// of the last mass computation; all other pieces are sheets. Principal moments of inertia are raised to at
// least a small fraction of the largest one, to bound the spin of a needle. A remnant so small relative to
// the loaded body that rounding hides its inertia counts as a cuboid. The mass is 0 without faces, and if
// doubles do not hold the inertia or its inverse, as of bodies wider than 1e80 m or smaller than 1e-80 m.
// O(pieces).
RigidFrame rigid_frame(const Body& body);

// A rigid motion x -> turn * x + shift.
struct RigidMap {
  glm::dmat3 turn{1.0};
  Vec3 shift{0};
  [[gnu::always_inline]] Vec3 operator()(const Vec3& p) const { return turn * p + shift; }
};

inline RigidMap map_of(const Placement& placement) {
  return {glm::mat3_cast(placement.orientation), placement.position};
}
// Returns the composition: first `inner`, then the inverse of `outer`.
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
  bool fixed = false;  // does not move
  bool asleep = false;
  Placement start;     // of the body at the beginning of the tick
  RigidMap now, next;  // body to world, at the beginning and at the end of the tick
  double margin = 0;   // distance from the swept body within which features matter, in units of length
  Box bounds;          // of the body during the tick, widened by the margin; in world coordinates
  double metre = 1;    // in units of length, see Environment
  double scale = 1;    // factor of all lengths of contact, see ContactLengths; in units of length
  double sunk = 0;     // depth below the ground at the beginning of the tick, in units of length

  bool passes_fixed = false;  // see KinematicBody
  double ignored_mass = 0;    // kg, likewise

  // Loss of spin due to contacts: a share of the spin [1/s], and a constant part [rad/s^2].
  double rolling_loss = 0, rolling_brake = 0;

  bool moves() const { return !fixed && !asleep; }
};

// Returns the index of a body in a list sorted by id, or the length of the list if it does not contain the
// body.
inline uint32_t index_of(std::span<const MovingBody> bodies, BodyId id) {
  const auto at = std::ranges::lower_bound(bodies, id, {}, &MovingBody::id);
  const bool found = at != bodies.end() && at->id == id;
  return static_cast<uint32_t>(found ? at - bodies.begin() : std::ssize(bodies));
}

// Returns the bounds of a box under a rigid motion.
inline Box moved(const RigidMap& map, const Box& box) {
  KERF_ASSERT(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z);
  const Vec3 middle = map(0.5 * (box.min + box.max)), half = 0.5 * (box.max - box.min);
  Vec3 extent(0);
  for (int column = 0; column < 3; ++column) extent += glm::abs(map.turn[column]) * half[column];
  return {middle - extent, middle + extent};
}

// Returns a box around all items of a cluster at both ends of a motion.
inline Box way_of(const Cluster& cluster, const RigidMap& now, const RigidMap& next) {
  KERF_ASSERT(cluster.begin < cluster.end && cluster.radius >= 0);
  const Vec3 from = now(cluster.centre), to = next(cluster.centre);
  return Box{glm::min(from, to), glm::max(from, to)}.wider(cluster.radius);
}

// Returns a box around all items of a cluster mapped by a rigid motion.
inline Box box_of(const Cluster& cluster, const RigidMap& map) {
  KERF_ASSERT(cluster.begin < cluster.end && cluster.radius >= 0);
  const Vec3 at = map(cluster.centre);
  return Box{at, at}.wider(cluster.radius);
}

// Contact lengths for bodies of about a metre or more; for smaller bodies they shrink in proportion.
struct ContactLengths {
  double skin = 0.002;         // m, kept between a point and a face
  double chord_skin = 0.001;   // between two chords
  double ground_skin = 0.001;  // between a point and the ground
  double reach = 0.010;        // max distance of detected contacts
};
inline constexpr ContactLengths kContactLengths;

}  // namespace kerf
