#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/heat/material.h"
#include "core/mesh/mesh.h"

namespace kerf {

// First and second moments of area of a set of triangles: the integrals of x and of x x^T over their surface,
// where x is the position relative to a fixed origin. Together with the area these sums determine the mass,
// centre and inertia of a thin shell; they can be added and subtracted face by face. Rounding errors grow
// with the distance from the origin (as (distance / remaining size)^4), so the origin should lie near the
// middle of the mesh.
struct AreaMoments {
  Vec3 first{0};                   // m^3
  std::array<double, 6> second{};  // m^4: xx, yy, zz, xy, xz, yz

  AreaMoments& operator+=(const AreaMoments& other);
  AreaMoments& operator-=(const AreaMoments& other);
  friend bool operator==(const AreaMoments&, const AreaMoments&) = default;
};

// Returns the moments of one triangle of the given area (m^2; triangle_area(t)), exact up to rounding: with
// corners p, q, r relative to the origin and s = p + q + r they are area / 3 * s and area / 12 * (p p^T + q
// q^T + r r^T + s s^T).
AreaMoments area_moments(const Triangle& t, double area, const Vec3& origin);

struct MassProperties {
  double mass = 0;          // kg
  Vec3 centre{0};           // m, of mass
  glm::dmat3 inertia{0.0};  // kg m^2, about the centre, along the axes of the frame of the triangles
};

// Returns the mass properties of a thin shell. `area` and `moments` are the sums over its faces, relative to
// `origin`; thickness in m, density in kg/m^3, both positive. If the area is not positive, e.g. due to
// rounding, the mass is 0 and the centre is at the origin. O(1).
MassProperties shell_mass(double area, const AreaMoments& moments, const Vec3& origin, double thickness,
                          double density);

// Moments of the volume enclosed by a set of triangles: the integrals of 1, of x and of x x^T, where x is the
// position relative to a fixed origin. They are signed sums over the tetrahedra between the origin and each
// triangle, and meaningful only for closed triangles (see closed_pieces). The origin should lie near the
// middle of the triangles (see AreaMoments).
struct VolumeMoments {
  double volume = 0;               // m^3
  Vec3 first{0};                   // m^4
  std::array<double, 6> second{};  // m^5: xx, yy, zz, xy, xz, yz

  VolumeMoments& operator+=(const VolumeMoments& other);
  friend bool operator==(const VolumeMoments&, const VolumeMoments&) = default;
};

// Returns the contribution of one triangle, exact up to rounding: with corners p, q, r relative to the
// origin, the signed volume v = p . (q x r) / 6 and s = p + q + r it is v, v / 4 * s and v / 20 * (p p^T + q
// q^T + r r^T + s s^T).
VolumeMoments volume_moments(const Triangle& t, const Vec3& origin);

// Returns the mass properties of a solid body from the sums over its triangles, relative to `origin`. The
// density is in kg/m^3 and positive. If the volume is not positive, e.g. due to rounding, the mass is 0 and
// the centre is at the origin. O(1).
MassProperties solid_mass(const VolumeMoments& moments, const Vec3& origin, double density);

// Returns the mass properties of two bodies that move as one. A body without mass is ignored.
MassProperties combine(const MassProperties& a, const MassProperties& b);

// The last computed volume of a piece of a solid body. Valid while the number of faces of the piece and, to
// the bit, their area are unchanged; a piece without a valid entry counts as open.
struct EnclosedPiece {
  MassProperties solid;  // of density 1, in the frame of the body
  size_t faces = 0;
  double area = 0;  // m^2
};

// The position and orientation of a body: x_world = orientation * x_body + position.
struct Placement {
  Vec3 position{0};                    // m
  glm::dquat orientation{1, 0, 0, 0};  // unit quaternion

  friend bool operator==(const Placement&, const Placement&) = default;

  Vec3 to_world(const Vec3& p) const { return orientation * p + position; }
  Vec3 to_body(const Vec3& p) const { return glm::conjugate(orientation) * (p - position); }
  // Converts a pose from the world to the body's frame. An identity placement preserves every bit.
  Pose to_body(const Pose& pose) const {
    return {to_body(pose.origin), glm::conjugate(orientation) * pose.direction};
  }
};

// The rigid motion of a body in world axes. The velocity is that of the body's point at the origin of its
// frame, i.e. at Placement::position: a cut that moves the centre of mass does not change it, and a detached
// piece copies its motion.
struct Motion {
  Vec3 velocity{0};    // m/s
  Vec3 spin{0};        // rad/s
  uint32_t quiet = 0;  // number of consecutive ticks slow enough for sleep
  bool asleep = false;

  friend bool operator==(const Motion&, const Motion&) = default;

  bool at_rest() const { return velocity == Vec3(0) && spin == Vec3(0); }
  void wake() {
    quiet = 0;
    asleep = false;
  }
  // Returns the velocity of the body's point at p in the world, m/s.
  Vec3 velocity_at(const Vec3& p, const Placement& placement) const {
    return velocity + glm::cross(spin, p - placement.position);
  }
};

// The sheet that the faces of a body represent. Precondition of its use: thickness and density are positive.
struct Sheet {
  double thickness = 0.001;  // m
  double density = 7850;     // kg/m^3, of mild steel; determines the mass (in vehicles, set from it)
  Substance substance;       // the material, for heating and cutting
  friend bool operator==(const Sheet&, const Sheet&) = default;
};

// External influences on all bodies of a world.
struct Environment {
  Vec3 gravity{0, -9.81, 0};     // m/s^2
  std::optional<double> ground;  // m, the height of a plane on which bodies rest, against gravity
  // Units of length of the world per metre: 1000 if positions, gravity, the ground and all velocities are in
  // millimetres. Contact distances and rest speeds scale with it.
  double metre = 1;

  friend bool operator==(const Environment&, const Environment&) = default;

  // Returns the unit vector against gravity; +Y without gravity.
  Vec3 up() const {
    const double g = glm::length(gravity);
    return g > 0 ? -gravity / g : Vec3(0, 1, 0);
  }
};

// A damped zero-length spring that holds a point of a piece while a user drags it.
struct Spring {
  PieceId piece;
  Vec3 at{0};  // m, in the frame of the body
  Vec3 to{0};  // m, in the world

  friend bool operator==(const Spring&, const Spring&) = default;
};

// Contact state of a point of one body near the faces of another, kept between ticks.
struct PointMemory {
  uint32_t point = 0;
  // Unit normal, in the frame of the other body, of the last nearby face, towards the point's side.
  Vec3 normal{0};
};

struct ImpulseMemory {
  uint64_t feature = 0;
  std::array<double, 3> impulse{};
};

// Contact state of two bodies near each other, kept between ticks. Lists are sorted by the first member of
// their elements.
struct PairMemory {
  BodyId first, second;  // first < second; the second is not valid for the ground
  std::vector<PointMemory> points_of_first, points_of_second;
  std::vector<ImpulseMemory> impulses;
  // Number of ticks for which the sheets have intersected since they met; 0 while they are apart.
  uint32_t crossed = 0;
  bool touching = false;  // whether they touched in the last tick
  // 2 if a body was kept from passing through the other in this tick, 1 if in the previous tick, else 0.
  uint8_t held = 0;
  // If the sheets intersect, the direction in which the first body was last pushed out; unit, in the world.
  Vec3 way_out{0};

  std::pair<BodyId, BodyId> bodies() const { return {first, second}; }
};

// Contact state of all pairs, sorted by their bodies.
using ContactMemory = std::vector<PairMemory>;

class World;

struct BodyState {
  BodyId id;
  Placement placement;
  Motion motion;
  friend bool operator==(const BodyState&, const BodyState&) = default;
};

// Two bodies that are near each other, or a body and the ground.
struct NearPair {
  BodyId first, second;   // first < second; the second is not valid for the ground
  bool touching = false;  // see PairMemory
  uint32_t crossed = 0;
  friend bool operator==(const NearPair&, const NearPair&) = default;
};

// Returns the states of the bodies that move or have moved. A body that was pinned or woken after it moved
// has no motion, so if bodies have moved `in_time`, all bodies placed elsewhere than at the origin count.
// O(bodies).
std::vector<BodyState> moved_bodies(const World& world, bool in_time);

// Get and set the pairs in World::contact_memory() without contact details; setting discards the details.
// `pairs` are sorted by their bodies. O(pairs).
std::vector<NearPair> known_pairs(const World& world);
void set_known_pairs(World& world, std::span<const NearPair> pairs);

}  // namespace kerf
