#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/base/tick.h"
#include "core/game/arena/arena.h"
#include "core/joints/joined_parts.h"
#include "core/physics/physics.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// The faces that carry the joints of a world, as they were loaded.
class JointFaces {
 public:
  JointFaces() = default;
  explicit JointFaces(const Joints& joints);

  // Whether a live face of a body carries a joint, by itself or as a part of a loaded face that does.
  // O(face slots).
  bool any_in(const Body& body) const;
  // Whether one of these faces of a body, which may be dead, does.
  bool any_of(const Body& body, const std::vector<FaceId>& faces) const;

 private:
  const std::vector<bool>* of(const Body& body) const;
  static bool carries(const std::vector<bool>& carriers, const Body& body, FaceId f);

  std::map<BodyId, std::vector<bool>> of_;  // by Body::loaded_as, then by loaded face
};

// The bodies of a match whose colliders are older than their faces, and when these are made anew.
//
// Making the collider of a vehicle takes as long as all else in a tick. So the physics goes on with the one
// that it has: for a few ticks while a beam removes faces, and for one where a piece came off. Two large ones
// are not made in the same tick.
class StaleColliders {
 public:
  // Notes whose faces a change at the time `now` has changed. Bodies that came have no collider yet.
  void note(const Delta& change, Ticks now);

  // Takes out the bodies whose colliders are to be made in the tick `now`, ascending: of those that are due,
  // the small ones, and of the large ones that which has been due for the longest time.
  std::vector<BodyId> take_due(const World& world, Ticks now);

 private:
  std::map<BodyId, Ticks> due_;
};

// The world of a wave of a match with its physics. Whoever changes the world tells follow(), which spreads
// the work over ticks: making the collider of a vehicle takes as long as all else in a tick.
class MatchWorld {
 public:
  // The generation of all bodies: slots are never used again within a wave.
  static constexpr uint32_t kGeneration = 0;

  MatchWorld() = default;
  // The bodies of an arena on its ground.
  explicit MatchWorld(const Arena& arena);

  World& world() { return world_; }
  const World& world() const { return world_; }
  const Physics& physics() const { return physics_; }
  // What changed in the present tick.
  const Delta& delta() const { return delta_; }
  // The index of a body among those of the arena.
  std::optional<size_t> of_arena(BodyId body) const;

  // To be called once all vehicles are there: makes all colliders, which takes as long as ten ticks.
  // `carried`: see Physics::tick.
  void make_colliders(std::span<const BodyId> carried);

  // Begins a tick of the time `now` of the match.
  void begin_tick(Ticks now);
  // Makes the colliders that are due, and looks for joints whose faces are gone.
  void renew_colliders();
  // Moves all bodies for a tick.
  void move(std::span<const Guided> guided, std::span<const BodyId> carried);
  // Nothing leaves the arena: its edge is a wall that takes away the motion against it.
  void keep_inside(const ArenaDescription& arena);
  // Notes bodies that were placed by something else than the physics in the course of move().
  void record_placed(std::vector<BodyId> bodies);
  // Notes that joints were let go by something else than beams.
  void record_released_joints() { joints_are_asked_ = true; }
  // Follows any other change of the world.
  void follow(Delta change);
  void remove(const std::vector<BodyId>& bodies);
  // Makes separated pieces bodies of their own, once the search for them is finished and it is known what
  // joints still hold, which the cuts of beams leave to this function. Parts that only hinges hold become
  // bodies that turn on them. Returns the pieces that came off, in the order in which they did: those that
  // are new and those that hung on hinges before.
  std::vector<Detached> separate();
  // Where too much lies about, the smallest pieces that lie still go, but nothing of the arena, nor what
  // `stays`.
  void clear_debris(const std::function<bool(BodyId)>& stays);
  // Heat flows in each body for some ticks at once, and not in all bodies in the same tick.
  void cool();

 private:
  Delta news_for_physics(const Delta& change) const;
  bool hangs(BodyId body, std::span<const HeldJoint> held) const;
  std::vector<Detached> take_off(std::vector<Detached> detached);

  World world_;
  Physics physics_;
  Ticks now_ = 0;
  StaleColliders stale_colliders_;
  JointFaces joint_faces_;
  bool joints_are_asked_ = false;  // faces that carry some are gone, and the physics does not know it yet
  bool hinges_are_asked_ = false;  // it knows it now, and `hanging_` does not
  std::vector<Detached> hanging_;  // pieces that turn on hinges of the bodies from which they were detached
  std::vector<BodyId> arena_;      // by index of the bodies of the arena
  Delta delta_;
};

}  // namespace kerf
