#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/game/arena/arena.h"
#include "core/joints/joined_parts.h"
#include "core/physics/physics.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// The faces that carry the joints of a world, as loaded.
class JointFaces {
 public:
  JointFaces() = default;
  explicit JointFaces(const Joints& joints);

  // Returns true if a live face of a body carries a joint, itself or as a part of a loaded face that does.
  // O(face slots).
  bool any_in(const Body& body) const;
  // Returns true if one of these faces of a body, live or dead, carries a joint.
  bool any_of(const Body& body, const std::vector<FaceId>& faces) const;

 private:
  const std::vector<bool>* of(const Body& body) const;
  static bool carries(const std::vector<bool>& carriers, const Body& body, FaceId f);

  std::map<BodyId, std::vector<bool>> of_;  // by Body::loaded_as, then by loaded face
};

// The bodies of a match with outdated colliders, and the ticks at which to rebuild them.
//
// Building the collider of a vehicle takes as long as the rest of a tick. The physics therefore uses the old
// collider for a few ticks while a beam removes faces, and for one tick after a piece was detached. At most
// one large collider is built per tick.
class StaleColliders {
 public:
  // Records the bodies whose faces a change at the time `now` modified. Created bodies have no collider
  // yet.
  void note(const Delta& change, Ticks now);

  // Removes and returns the bodies whose colliders to build in the tick `now`, ascending: all small bodies
  // that are due, and the large one that has been due longest.
  std::vector<BodyId> take_due(const World& world, Ticks now);

 private:
  std::map<BodyId, Ticks> due_;
};

// The world of a wave of a match with its physics. Report each change of the world to follow(), which
// spreads the work over ticks (see StaleColliders).
class MatchWorld {
 public:
  // Generation of all bodies: slots are never reused within a wave.
  static constexpr uint32_t kGeneration = 0;

  MatchWorld() = default;
  explicit MatchWorld(const Arena& arena);

  World& world() { return world_; }
  const World& world() const { return world_; }
  const Physics& physics() const { return physics_; }
  const Delta& delta() const { return delta_; }
  // The index of a body in the arena; nullopt if it is not of the arena.
  std::optional<size_t> of_arena(BodyId body) const;

  // Builds all colliders, which takes as long as ten ticks. Call once all vehicles exist. `carried`: see
  // Physics::tick.
  void make_colliders(std::span<const BodyId> carried);

  void begin_tick(Ticks now);
  // Builds the colliders that are due, and searches for joints whose faces were removed.
  void renew_colliders();
  void move(std::span<const KinematicBody> guided, std::span<const BodyId> carried);
  // Keeps bodies inside the arena: its edge removes the velocity against it.
  void keep_inside(const ArenaDescription& arena);
  // Records bodies that were placed outside the physics during move().
  void record_placed(std::vector<BodyId> bodies);
  // Records that joints were released other than by beams.
  void record_released_joints() { joints_requested_ = true; }
  // Processes any other change of the world.
  void follow(Delta change);
  void remove(const std::vector<BodyId>& bodies);
  // Detaches separated pieces as bodies once the search for them is complete, after updating the intact
  // joints. Parts held only by hinges become bodies that turn on them. Returns the detached pieces in order:
  // new ones, and those that hung on hinges before.
  std::vector<Detached> separate();
  // If there are too many loose bodies, removes the smallest resting pieces, except bodies of the arena and
  // those for which `stays` returns true.
  void clear_debris(const std::function<bool(BodyId)>& stays);
  // Conducts heat in each body for several ticks at a time, staggered over the bodies.
  void cool();

 private:
  void find_joints();
  Delta delta_for_physics(const Delta& change) const;
  bool hangs(BodyId body, std::span<const HeldJoint> held) const;
  std::vector<Detached> detach_hanging(std::vector<Detached> detached);

  World world_;
  Physics physics_;
  Ticks now_ = 0;
  StaleColliders stale_colliders_;
  JointFaces joint_faces_;
  size_t known_joints_ = 0;        // of the world, in `joint_faces_`
  bool joints_requested_ = false;  // faces that carry joints were removed; the physics is not updated yet
  bool hinges_requested_ = false;  // the physics is updated, but `hanging_` is not
  std::vector<Detached> hanging_;  // pieces that turn on hinges of the bodies from which they were detached
  std::vector<BodyId> arena_;      // by index of the bodies of the arena
  Delta delta_;
};

}  // namespace kerf
