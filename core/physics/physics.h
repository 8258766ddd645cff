#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/joints/joined_parts.h"
#include "core/physics/contact/collider.h"
#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// Returns the kind of machine on which motion is bit-identical: processor, C library, solver, and revision
// of Kerf's own part, such as "x86_64 glibc-2.36 bullet-3.24 motion-5". The solver uses functions of the C
// library whose last bits may differ between kinds, and Debian's build of it for arm64 contains fused
// multiply-adds: motion differs there from that on x86-64 (tests/run --arm64).
std::string machine_kind();

// Applies the spring of the world to its body for one tick of `seconds`: a critically damped spring between
// the attached point and the target, with an acceleration of at most kMaxSpringAcceleration. Wakes the body.
// No-op without a spring, or if the piece does not exist, is pinned, hidden or has no mass.
void apply_spring(World& world, double seconds);

// Updates the spring of the world if a change detached its piece as a body of its own.
void follow_with_spring(World& world, const Delta& delta);

inline constexpr double kSpringFrequency =
    20;  // rad/s, of the undamped spring with the effective mass at the point
inline constexpr double kMaxSpringAcceleration = 100;  // m/s^2

class SolverMemory;

// Counts of the work of a tick, for statistics and display.
struct TickStatistics {
  size_t bodies = 0, awake = 0;
  size_t candidates = 0;  // pairs of bodies whose bounds overlap
  size_t pairs = 0;       // of these, those whose faces were tested
  size_t contacts = 0;
  size_t held = 0;     // bodies held back to prevent intersection
  size_t crossed = 0;  // pairs of sheets that intersect and do not touch
};

// A body whose motion the caller controls.
struct KinematicBody {
  BodyId body;
  bool passes_fixed = false;  // does not touch fixed bodies
  double ignored_mass = 0;    // lighter bodies [kg] do not stop it, and may intersect it until they are apart
};

// Moves the bodies of a world as rigid sheets: they fall, collide with each other and the ground, slide, and
// fall asleep. A joint connects two bodies if its parts belong to different bodies (see held_joints); such
// bodies do not touch each other.
//
// The entire state of the simulation lies in the world: placements, motions and World::contact_memory(). This
// class only caches colliders and intact joints, which are functions of the bodies, so a new instance
// continues bit-identically. There is one exception, because the collider of a large body takes longer to
// build than a tick: within a history step, a body of more than kMaxUnderBeam faces keeps its collider while
// the beam cuts it. Therefore a new instance continues identically only from the beginning of a history step;
// see begin_step().
class Physics {
 public:
  Physics();
  ~Physics();
  Physics(Physics&&) noexcept;
  Physics& operator=(Physics&&) noexcept;

  // Updates the caches after a change of the world. Must follow every change except those of tick().
  void follow(const Delta& delta);

  // Must be called at the beginning of each history step.
  void begin_step();

  // The next tick rebuilds the colliders of these bodies.
  void renew(std::span<const BodyId> bodies) { changed_.insert(bodies.begin(), bodies.end()); }
  // The next tick finds the intact joints again.
  void forget_joints() { joints_.reset(); }

  // Advances all bodies by 1/120 s. Returns the bodies that moved. The caller advances the clock of the
  // world. `under_beam`: a beam is on and will cut between ticks. `guided`: kinematic bodies, in any order,
  // each once. `carried`: bodies that are part of others, without contacts or mass of their own; ascending.
  Delta tick(World& world, bool under_beam = false, std::span<const KinematicBody> guided = {},
             std::span<const BodyId> carried = {});
  // Prepares the next tick: builds its colliders and finds the intact joints. The bodies keep the masses that
  // they have.
  void prepare(const World& world, std::span<const BodyId> carried = {});
  // Returns true if the next tick builds a collider of this body and computes its mass.
  bool needs_collider(const World& world, BodyId id, bool under_beam) const;
  static constexpr size_t kMaxUnderBeam = 20'000;

  // Returns true if the intact joints are cached, i.e. if follow() was not called since the last tick.
  bool has_joints_cached() const { return joints_.has_value(); }

  const TickStatistics& statistics() const { return statistics_; }
  // Colliders built by ticks so far, by body.
  const std::map<BodyId, Collider>& colliders() const { return colliders_; }
  // Contacts of the last tick.
  const std::vector<TouchingPair>& pairs() const { return pairs_; }

 private:
  // Computes the masses of the bodies whose colliders the tick builds.
  void update_changed_masses(World& world, std::span<const BodyId> ids, bool under_beam) const;
  // Returns independent tasks that build these colliders and find the intact joints.
  std::vector<std::function<void()>> preparations(const World& world, std::span<const BodyId> ids,
                                                  bool under_beam);
  // Runs these tasks concurrently.
  void update_caches(World& world, std::span<const BodyId> ids, bool under_beam);
  std::vector<MovingBody> moving_bodies(World& world, bool under_beam, std::span<const BodyId> carried);
  void forget_collider(BodyId id);
  // Discards the contact details of bodies whose collider is older than their faces: they consist of indices
  // of its points and chords, which the next collider numbers differently.
  void forget_outdated(ContactMemory& memory) const;

  std::map<BodyId, Collider> colliders_;
  std::set<BodyId> changed_;  // bodies whose faces have changed since their collider was built
  std::set<BodyId> of_step_;  // bodies whose colliders were used in this step
  std::optional<std::vector<HeldJoint>> joints_;  // nullopt: out of date
  std::unique_ptr<SolverMemory> solver_;
  std::vector<TouchingPair> pairs_;
  TickStatistics statistics_;
};

// Detaches every cut-off piece as a body of its own, so that it can move (see detach). In each visible body
// the piece with the lowest label stays. The other pieces inherit its velocity and spin, are not pinned, and
// are pushed away from it by equal and opposite impulses along the line between the centres of mass, to a
// relative speed of kPushApart. Pinned bodies are not pushed, nor are parts that turn on joints and were not
// cut off, nor pieces whose walls touch those of another piece (see mating_labels). New bodies get
// `generation` (see BodyId). Appends the changes to `delta`, and wakes the changed bodies.
//
// Precondition: all searches for separated pieces are finished. O(pieces) if no piece was cut off.
void release_pieces(World& world, uint32_t generation, Delta& delta);

// Returns true if release_pieces() would detach a piece of this body. O(pieces).
bool has_pieces_off(const Body& body);

inline constexpr double kPushApart = 0.03;  // m/s, proportionally less for bodies smaller than a metre

}  // namespace kerf
