#pragma once

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

// The kind of machine on which bodies move to the same bits: its processor, C library and solver, and the
// revision of Kerf's own part, such as "x86_64 glibc-2.36 bullet-3.24 motion-2". The solver uses functions of
// the C library whose last bits differ between kinds.
std::string machine_kind();

// Lets the spring of the world act on the body that it holds for one tick of so many seconds: its velocity
// and spin change as by a critically damped spring between the held point and the far end, which accelerates
// the point by at most kMaxPull. The body wakes. Nothing happens without a spring, or if the piece does not
// exist, is pinned, hidden or has no mass.
void pull(World& world, double seconds);

inline constexpr double kPullFrequency = 20;  // rad/s, of the undamped spring with the mass that it feels
inline constexpr double kMaxPull = 100;       // m/s^2

class SolverMemory;

// The work of a tick, for statistics and for the display.
struct TickStatistics {
  size_t bodies = 0, awake = 0;
  size_t candidates = 0;  // pairs of bodies whose bounds overlap
  size_t pairs = 0;       // of these, those whose faces were looked at
  size_t contacts = 0;
  size_t held = 0;     // bodies that did not go all of their way, lest they intersect
  size_t crossed = 0;  // pairs of sheets that intersect and do not touch
};

// A body that something besides the physics steers.
struct Guided {
  BodyId body;
  bool glides = false;      // it does not touch fixed bodies
  double sweeps_aside = 0;  // kg: lighter bodies do not stop it, and may intersect it until they are apart
};

// Lets the bodies of a world move as rigid sheets: they fall, touch each other and the ground, slide, and
// fall asleep.
//
// Joints hold bodies together: those whose two parts belong to different bodies (see held_joints). Such
// bodies do not touch each other.
//
// All state that decides what happens lies in the world: placements, motions and World::contact_memory().
// This class only keeps colliders and which joints hold, which are functions of the faces; one that was made
// anew goes on to the bit like the old one. There is one exception, for making the collider of a large body
// takes longer than a tick may: within a step of the history, a body of more than kMaxUnderBeam faces keeps
// its collider while the beam cuts it. So one that was made anew goes on like the old one from where a step
// begins, see begin_step().
class Physics {
 public:
  Physics();
  ~Physics();
  Physics(Physics&&) noexcept;
  Physics& operator=(Physics&&) noexcept;

  // Makes what is kept follow a change of the world. Must be called for every change but those of tick().
  void follow(const Delta& delta);

  // To be called where a step of the history begins.
  void begin_step();

  // Has the next tick make the colliders of these bodies anew.
  void renew(std::span<const BodyId> bodies) { changed_.insert(bodies.begin(), bodies.end()); }
  // Has the next tick find the joints that hold anew.
  void forget_joints() { joints_.reset(); }

  // Advances all bodies by 1/120 s. Returns the bodies that moved. The clock of the world is left to the
  // caller. `under_beam`: a beam is on, and the next ticks will follow further cuts. `guided`: bodies that
  // are treated in another way than all others, in any order, each once. `carried`, ascending: bodies that
  // are a part of others, and so neither touch anything nor have a mass of their own.
  Delta tick(World& world, bool under_beam = false, std::span<const Guided> guided = {},
             std::span<const BodyId> carried = {});
  // Makes the colliders that the next tick would make, and finds the joints that hold. The tick then weighs
  // none of these bodies.
  void prepare(const World& world, std::span<const BodyId> carried = {});
  // Whether such a tick makes a collider of this body, if any is awake, and weighs the body (see
  // update_mass_properties).
  bool makes_collider(const World& world, BodyId id, bool under_beam) const;
  static constexpr size_t kMaxUnderBeam = 20'000;

  // Whether the joints are known that hold, i.e. whether no change was followed since the last tick.
  bool knows_joints() const { return joints_.has_value(); }

  const TickStatistics& statistics() const { return statistics_; }
  // The colliders of the bodies, as far as ticks have needed them.
  const std::map<BodyId, Collider>& colliders() const { return colliders_; }
  // The contacts of the last tick.
  const std::vector<TouchingPair>& pairs() const { return pairs_; }

 private:
  // Weighs the bodies of which the tick makes colliders: both are functions of the faces.
  void weigh_changed(World& world, std::span<const BodyId> ids, bool under_beam) const;
  // What makes their colliders and finds the joints that hold if they are not known; to be done in any order.
  std::vector<std::function<void()>> preparations(const World& world, std::span<const BodyId> ids,
                                                  bool under_beam);
  // Weighs them, makes their colliders, and finds the joints that hold if they are not known, all at the same
  // time.
  void learn_faces(World& world, std::span<const BodyId> ids, bool under_beam);
  std::vector<MovingBody> moving_bodies(World& world, bool under_beam, std::span<const BodyId> carried);
  void forget_collider(BodyId id);

  std::map<BodyId, Collider> colliders_;
  std::set<BodyId> changed_;  // of these bodies, those whose faces have changed since
  std::set<BodyId> of_step_;  // and those whose colliders a tick of the same step has used
  std::optional<std::vector<HeldJoint>> joints_;  // nothing: not known
  std::unique_ptr<SolverMemory> solver_;
  std::vector<TouchingPair> pairs_;
  TickStatistics statistics_;
};

}  // namespace kerf
