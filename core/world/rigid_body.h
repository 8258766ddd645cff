#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/heat/material.h"

namespace kerf {

// The position and orientation of a body: x_world = orientation * x_body + position.
struct Placement {
  Vec3 position{0};                    // m
  glm::dquat orientation{1, 0, 0, 0};  // unit quaternion

  friend bool operator==(const Placement&, const Placement&) = default;

  Vec3 to_world(const Vec3& p) const { return orientation * p + position; }
  Vec3 to_body(const Vec3& p) const { return glm::conjugate(orientation) * (p - position); }
  // A pose of the world in the body's frame. An identity placement preserves every bit.
  Pose to_body(const Pose& pose) const {
    return {to_body(pose.origin), glm::conjugate(orientation) * pose.direction};
  }
};

// The rigid motion of a body in world axes. The velocity is that of the point of the body that lies at the
// origin of its frame, i.e. at Placement::position: so it stays what it is when a cut moves the centre of
// mass, and a piece that is detached inherits its motion by a copy.
struct Motion {
  Vec3 velocity{0};    // m/s
  Vec3 spin{0};        // rad/s
  uint32_t quiet = 0;  // ticks for which the body was slow enough to fall asleep
  bool asleep = false;

  friend bool operator==(const Motion&, const Motion&) = default;

  bool at_rest() const { return velocity == Vec3(0) && spin == Vec3(0); }
  void wake() {
    quiet = 0;
    asleep = false;
  }
  // The velocity of the point of the body that is at p in the world, m/s.
  Vec3 velocity_at(const Vec3& p, const Placement& placement) const {
    return velocity + glm::cross(spin, p - placement.position);
  }
};

// The sheet that the faces of a body stand for. Precondition of its use: thickness and density are positive.
struct Sheet {
  double thickness = 0.001;  // m
  double density =
      7850;             // kg/m^3, of mild steel; what the body weighs (vehicles are given their weight by it)
  Substance substance;  // the material, which tells how it is heated and cut
  friend bool operator==(const Sheet&, const Sheet&) = default;
};

// The influences on all bodies of a world.
struct Environment {
  Vec3 gravity{0, -9.81, 0};     // m/s^2
  std::optional<double> ground;  // m, the height of a plane on which bodies rest, against gravity
  // How many units of length of the world are a metre: 1000 where positions are in millimetres, and gravity,
  // the ground and all velocities with them. The lengths and speeds by which bodies touch and come to rest
  // follow it.
  double metre = 1;

  friend bool operator==(const Environment&, const Environment&) = default;

  // Unit, against gravity; +Y without gravity.
  Vec3 up() const {
    const double g = glm::length(gravity);
    return g > 0 ? -gravity / g : Vec3(0, 1, 0);
  }
};

// A damped spring without length that holds one point of a piece, for a person who drags it.
struct Spring {
  PieceId piece;
  Vec3 at{0};  // m, in the frame of the body
  Vec3 to{0};  // m, in the world

  friend bool operator==(const Spring&, const Spring&) = default;
};

// The memory of a point of one body beside the faces of another.
struct PointMemory {
  uint32_t point = 0;
  // Unit, in the frame of the other body: the normal of the face that it was last near, towards its side.
  Vec3 normal{0};
};

struct ImpulseMemory {
  uint64_t feature = 0;
  std::array<double, 3> impulse{};
};

// The memory of two bodies that are near each other. Lists are sorted by their first members.
struct PairMemory {
  BodyId first, second;  // first < second; the second is not valid for the ground
  std::vector<PointMemory> points_of_first, points_of_second;
  std::vector<ImpulseMemory> impulses;
  // For how many ticks the sheets have intersected since they met; 0 while they are apart.
  uint32_t crossed = 0;
  bool touching = false;  // they did in the last tick
  // 2 if a body was held in this tick so as not to get through the other, 1 if that was so in the last one.
  uint8_t held = 0;
  // Unit, in the world, where they intersect: the way on which the first body was pushed out in the last
  // tick.
  Vec3 way_out{0};

  std::pair<BodyId, BodyId> bodies() const { return {first, second}; }
};

// The memory of all pairs, sorted by their bodies.
using ContactMemory = std::vector<PairMemory>;

class World;

// Where a body is and how it moves.
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

// The states of the bodies of a world that move or have moved. O(bodies).
std::vector<BodyState> moved_bodies(const World& world);

// The contact memory of pairs of bodies, without the details of their contacts (see World::contact_memory),
// and the reverse: nothing else is known of them then. `pairs` are sorted by their bodies. O(pairs).
std::vector<NearPair> known_pairs(const World& world);
void set_known_pairs(World& world, std::span<const NearPair> pairs);

}  // namespace kerf
