#include "core/physics/physics.h"

#include <gnu/libc-version.h>
#include <LinearMath/btScalar.h>
#include <sys/utsname.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/base/assert.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/edit/detach.h"
#include "core/physics/contact/mating.h"
#include "core/physics/motion_limits.h"
#include "core/physics/sleep.h"
#include "core/physics/solver.h"
#include "core/world/body_mass.h"

namespace kerf {

namespace {

// Revision of Kerf's own motion code. Increase it with every change that alters the bits of a motion.
constexpr int kRevision = 5;

// Returns the inverse of the inertia in world axes.
glm::dmat3 inverse_inertia(const RigidFrame& frame, const Placement& placement) {
  KERF_ASSERT(frame.inertia.x > 0 && frame.inertia.y > 0 && frame.inertia.z > 0);
  const glm::dmat3 axes = glm::mat3_cast(placement.orientation * frame.axes);
  glm::dmat3 inverse(0.0);
  for (int k = 0; k < 3; ++k) inverse[k][k] = 1 / frame.inertia[k];
  return axes * inverse * glm::transpose(axes);
}

// Returns the matrix of the cross product r x ...
glm::dmat3 cross_matrix(const Vec3& r) {
  return {Vec3(0, r.z, -r.y), Vec3(-r.z, 0, r.x), Vec3(r.y, -r.x, 0)};
}

// Returns the acceleration of the held point by the spring (m/s^2).
Vec3 wanted_acceleration(const Vec3& way, const Vec3& velocity, double metre) {
  KERF_ASSERT(metre > 0);
  const Vec3 wanted = kSpringFrequency * kSpringFrequency * way - 2 * kSpringFrequency * velocity;
  const double size = glm::length(wanted);
  return size > kMaxSpringAcceleration * metre ? kMaxSpringAcceleration * metre / size * wanted : wanted;
}

void apply_spring(Body& body, const Spring& spring, double metre, double seconds) {
  const RigidFrame frame = rigid_frame(body);
  if (!(frame.mass > 0)) return;
  const Vec3 centre = body.placement.to_world(frame.centre), held = body.placement.to_world(spring.at);
  const Vec3 arm = held - centre;
  const glm::dmat3 inertia = inverse_inertia(frame, body.placement), cross = cross_matrix(arm);
  const glm::dmat3 response = glm::dmat3(1 / frame.mass) - cross * inertia * cross;
  const Vec3 velocity = body.motion.velocity_at(held, body.placement);
  const Vec3 impulse =
      glm::inverse(response) * (seconds * wanted_acceleration(spring.to - held, velocity, metre));
  const Vec3 spin = inertia * glm::cross(arm, impulse);
  body.motion.spin += spin;
  body.motion.velocity += impulse / frame.mass + glm::cross(spin, body.placement.position - centre);
}

constexpr double kFullLengths = 0.4;   // diagonal from which on the lengths of contact are unscaled [m]
constexpr double kRollingLoss = 0.35;  // relative to the square root of gravity over the size of a body
constexpr double kRollingBrake = 0.7;  // relative to gravity over the size of a body
constexpr double kPressedOut = 0.1;    // permitted gain [m/s], see SpeedLimit

// Returns the placement of a body after a tick if nothing stops it.
Placement moved_on(const MovingBody& b, const Vec3& gravity) {
  if (b.fixed || b.asleep) return b.body->placement;
  const Motion& motion = b.body->motion;
  Placement principal = b.frame.in_world(b.body->placement);
  principal.position += kTick * (motion.velocity_at(principal.position, b.body->placement) + kTick * gravity);
  const glm::dquat turn(0, 0.5 * kTick * motion.spin);
  principal.orientation = glm::normalize(principal.orientation + turn * principal.orientation);
  return b.frame.body_at(principal);
}

void set_way(MovingBody& b, const Vec3& gravity) {
  b.start = b.body->placement;
  b.now = map_of(b.start);
  b.next = map_of(moved_on(b, gravity));
  b.bounds = moved(b.now, b.collider->bounds);
  if (b.moves()) b.bounds.add(moved(b.next, b.collider->bounds));
  b.margin = kContactLengths.reach * b.scale;
  b.bounds = b.bounds.wider(b.margin);
}

// Sets the state of a body at the beginning of a tick. Precondition: `b` has its body and collider.
void begin_tick(MovingBody& b, const Environment& around) {
  KERF_ASSERT(b.body != nullptr && b.collider != nullptr);
  const Body& body = *b.body;
  b.frame = rigid_frame(body);
  b.fixed = body.pinned || !(b.frame.mass > 0);
  b.asleep = body.motion.asleep;
  b.metre = around.metre;
  b.scale = std::min(b.metre, glm::length(body.loaded.max - body.loaded.min) / kFullLengths);
  set_way(b, around.gravity);
  b.sunk = depth_below_ground(b, b.now, around);
}

// Sheet metal rolls badly: bodies that touched lose spin, small ones faster, and stop unless on a joint.
void set_rolling_loss(std::span<MovingBody> bodies, std::span<const BodyJoint> joints,
                      const ContactMemory& before, const Vec3& gravity) {
  const auto lose = [&](BodyId id) {
    const uint32_t index = index_of(bodies, id);
    if (index == bodies.size()) return;
    MovingBody& body = bodies[index];
    const Box& box = body.collider->bounds;
    const double per_second2 = glm::length(gravity) / glm::length(box.max - box.min);
    body.rolling_loss = kRollingLoss * std::sqrt(per_second2);
    body.rolling_brake = kRollingBrake * per_second2;
  };
  for (const PairMemory& m : before) {
    if (!m.touching) continue;
    lose(m.first);
    if (m.second.valid()) lose(m.second);
  }
  for (const BodyJoint& j : joints) bodies[j.first].rolling_brake = bodies[j.second].rolling_brake = 0;
}

// Lifts bodies that the solver moved below the ground back to it, or to their previous depth if that was
// larger; bodies pushing them may be heavier or faster than the ground contacts can stop in a tick.
void stay_above_ground(std::span<MovingBody> bodies, const Environment& around) {
  for (MovingBody& b : bodies) {
    if (!b.moves()) continue;
    const double sunk = depth_below_ground(b, map_of(b.body->placement), around);
    if (sunk > b.sunk) b.body->placement.position += (sunk - b.sunk) * around.up();
  }
}

// Sets the ways of the bodies to end where the solver has moved them.
void set_solved_way(std::span<MovingBody> bodies) {
  for (MovingBody& b : bodies) {
    b.next = b.moves() ? map_of(b.body->placement) : b.now;
    b.margin = 0;
    b.bounds = moved(b.now, b.collider->bounds);
    if (b.moves()) b.bounds.add(moved(b.next, b.collider->bounds));
  }
}

void guide(std::span<MovingBody> bodies, std::span<const KinematicBody> guided) {
  for (const KinematicBody& g : guided) {
    const uint32_t index = index_of(bodies, g.body);
    if (index == bodies.size()) continue;
    bodies[index].passes_fixed = g.passes_fixed;
    bodies[index].ignored_mass = g.ignored_mass;
  }
}

// Removes and returns the pairs of which no body moves.
std::vector<TouchingPair> take_resting(std::span<const MovingBody> bodies, std::vector<TouchingPair>& pairs) {
  const auto moves = [&](const TouchingPair& p) {
    return bodies[p.first].moves() || (p.second != TouchingPair::kGround && bodies[p.second].moves());
  };
  const auto at = std::stable_partition(pairs.begin(), pairs.end(), moves);
  std::vector<TouchingPair> resting(std::make_move_iterator(at), std::make_move_iterator(pairs.end()));
  pairs.erase(at, pairs.end());
  return resting;
}

// Moves the memory of pairs to the end of `memory`.
void take_memory(std::vector<TouchingPair>& pairs, ContactMemory& memory) {
  for (TouchingPair& p : pairs) {
    remember_impulses(p.contacts, p.memory);
    memory.push_back(std::move(p.memory));
  }
}

// Returns the contact memory after the tick. Pairs of sleeping bodies were not processed; their memory
// stays. Precondition: both lists are sorted.
ContactMemory memory_after(std::span<const MovingBody> bodies, const ContactMemory& before,
                           std::vector<TouchingPair>& pairs, std::vector<TouchingPair>& resting) {
  KERF_ASSERT(std::ranges::is_sorted(before, {}, &PairMemory::bodies));
  ContactMemory memory;
  take_memory(pairs, memory);
  take_memory(resting, memory);
  const auto end_of = [&](size_t pairs_before) {
    return memory.begin() + static_cast<ptrdiff_t>(pairs_before);
  };
  std::ranges::inplace_merge(memory, end_of(pairs.size()), {}, &PairMemory::bodies);
  KERF_ASSERT(std::ranges::is_sorted(memory, {}, &PairMemory::bodies));
  const size_t known = memory.size();
  const auto rests = [&](BodyId id) {
    const uint32_t index = index_of(bodies, id);
    return index < bodies.size() && !bodies[index].moves();
  };
  for (const PairMemory& m : before) {
    if (rests(m.first) && (!m.second.valid() || rests(m.second)) &&
        !std::ranges::binary_search(memory.begin(), end_of(known), m.bodies(), {}, &PairMemory::bodies))
      memory.push_back(m);
  }
  std::ranges::inplace_merge(memory, end_of(known), {}, &PairMemory::bodies);
  return memory;
}

bool takes_part(const World& world, BodyId id, std::span<const BodyId> carried) {
  const Body& b = world.body(id);
  return !b.hidden && b.mesh.live_faces() > 0 && !std::binary_search(carried.begin(), carried.end(), id);
}

// Counts the bodies that can be touched, and those that could move, regardless of their masses.
TickStatistics count_bodies(const World& world, std::span<const BodyId> carried) {
  TickStatistics count;
  for (const BodyId id : world.ids()) {
    const Body& b = world.body(id);
    if (!takes_part(world, id, carried)) continue;
    ++count.bodies;
    if (!b.pinned && !b.motion.asleep) ++count.awake;
  }
  return count;
}

std::vector<BodyId> taking_part(const World& world, std::span<const BodyId> carried) {
  std::vector<BodyId> ids = world.ids();
  std::erase_if(ids, [&](BodyId id) { return !takes_part(world, id, carried); });
  std::ranges::sort(ids);
  return ids;
}

void do_all(std::span<const std::function<void()>> work) {
  for_each_range(work.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) work[i]();
  });
}

// Returns the labels of a body that have faces, except the lowest of them.
std::vector<uint32_t> pieces_off(const Body& body) {
  std::vector<uint32_t> labels;
  bool first = true;
  for (uint32_t p = 0; p < body.pieces.size(); ++p) {
    if (body.pieces[p].faces == 0) continue;
    if (!first) labels.push_back(p);
    first = false;
  }
  return labels;
}

// Changes the velocity of a body as an impulse at its centre of mass does.
void push(Body& body, const Vec3& change) {
  if (!body.pinned) body.motion.velocity += change;
}

void push_apart(Body& rest, Body& piece, double metre) {
  const RigidFrame of_rest = rigid_frame(rest), of_piece = rigid_frame(piece);
  KERF_ASSERT(metre > 0);
  const double mass = of_rest.mass + of_piece.mass;
  const Vec3 way = piece.placement.to_world(of_piece.centre) - rest.placement.to_world(of_rest.centre);
  const double length = glm::length(way), size = glm::length(rest.loaded.max - rest.loaded.min);
  // Pieces around the same centre have no direction of separation.
  if (!(mass > 0) || !(length > 1e-3 * size)) return;
  const Vec3 apart = kPushApart * std::min(metre, size) / length * way;
  push(piece, of_rest.mass / mass * apart);
  push(rest, -of_piece.mass / mass * apart);
}

}  // namespace

std::string machine_kind() {
  utsname machine{};
  const std::string processor = uname(&machine) == 0 ? machine.machine : "unknown";
  const int version = btGetVersion();
  return processor + " glibc-" + gnu_get_libc_version() + " bullet-" + std::to_string(version / 100) + "." +
         std::to_string(version % 100) + " motion-" + std::to_string(kRevision);
}

void apply_spring(World& world, double seconds) {
  KERF_ASSERT(seconds > 0);
  const std::optional<Spring>& spring = world.spring();
  if (!spring || !world.contains(spring->piece.body)) return;
  Body& body = world.body(spring->piece.body);
  const uint32_t label = spring->piece.label;
  const bool exists = label < body.pieces.size() && body.pieces[label].faces > 0;
  if (!exists || body.pinned || body.hidden) return;
  body.motion.wake();
  apply_spring(body, *spring, world.environment().metre, seconds);
}

void follow_with_spring(World& world, const Delta& delta) {
  if (!world.spring()) return;
  Spring spring = *world.spring();
  spring.piece = id_after(delta, spring.piece);
  if (spring != *world.spring()) world.set_spring(spring);
}

Physics::Physics() : solver_(std::make_unique<SolverMemory>()) {}
Physics::~Physics() = default;
Physics::Physics(Physics&&) noexcept = default;
Physics& Physics::operator=(Physics&&) noexcept = default;

void Physics::follow(const Delta& delta) {
  if (delta.replaced) colliders_.clear();
  const auto changes_faces = [](const BodyDelta& b) {
    return !b.added.empty() || !b.dead.empty() || !b.relabelled.empty();
  };
  const bool faces_changed = std::any_of(delta.bodies.begin(), delta.bodies.end(), changes_faces);
  if (faces_changed || delta.changes_bodies()) joints_.reset();
  for (const BodyDelta& b : delta.bodies) changed_.insert(b.body);
  // The walls of a body that became a sheet no longer mate.
  changed_.insert(delta.mass_changed.begin(), delta.mass_changed.end());
  for (BodyId id : delta.created) forget_collider(id);
  for (BodyId id : delta.destroyed) forget_collider(id);
  for (const Detached& d : delta.detached) {
    forget_collider(d.from);
    forget_collider(d.to);
  }
}

void Physics::forget_collider(BodyId id) {
  colliders_.erase(id);
  changed_.erase(id);
}

void Physics::begin_step() { of_step_.clear(); }

bool Physics::needs_collider(const World& world, BodyId id, bool under_beam) const {
  if (!colliders_.contains(id)) return true;
  if (!changed_.contains(id)) return false;
  return !under_beam || !of_step_.contains(id) || world.body(id).mesh.live_faces() <= kMaxUnderBeam;
}

void Physics::update_changed_masses(World& world, std::span<const BodyId> ids, bool under_beam) const {
  for (const BodyId id : ids) {
    if (needs_collider(world, id, under_beam)) update_mass_properties(world.body(id));
  }
}

std::vector<std::function<void()>> Physics::preparations(const World& world, std::span<const BodyId> ids,
                                                         bool under_beam) {
  std::vector<std::function<void()>> work;
  for (const BodyId id : ids) {
    if (!needs_collider(world, id, under_beam)) continue;
    const Body& body = world.body(id);
    Collider& collider = colliders_[id];
    work.emplace_back([&collider, &body] {
      collider = make_collider(body.mesh);
      collider.wall_corners = wall_corners(body);
    });
    changed_.erase(id);
  }
  if (!joints_) work.emplace_back([&] { joints_ = held_joints(world); });
  return work;
}

void Physics::update_caches(World& world, std::span<const BodyId> ids, bool under_beam) {
  std::vector<std::function<void()>> weighing;
  for (const BodyId id : ids) {
    if (!needs_collider(world, id, under_beam)) continue;
    Body& body = world.body(id);
    weighing.emplace_back([&body] { update_mass_properties(body); });
  }
  std::vector<std::function<void()>> work = preparations(world, ids, under_beam);
  work.insert(work.end(), weighing.begin(), weighing.end());
  do_all(work);
}

void Physics::prepare(const World& world, std::span<const BodyId> carried) {
  do_all(preparations(world, taking_part(world, carried), false));
}

std::vector<MovingBody> Physics::moving_bodies(World& world, bool under_beam,
                                               std::span<const BodyId> carried) {
  constexpr size_t kAtATime = 8;  // bodies per task of a thread
  const std::vector<BodyId> ids = taking_part(world, carried);
  update_caches(world, ids, under_beam);
  of_step_.insert(ids.begin(), ids.end());
  std::vector<MovingBody> bodies(ids.size());
  for (size_t i = 0; i < ids.size(); ++i) bodies[i].body = &world.body(ids[i]);
  for_each_range(ids.size(), kAtATime, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      bodies[i].id = ids[i];
      bodies[i].collider = &colliders_.at(ids[i]);
      begin_tick(bodies[i], world.environment());
    }
  });
  return bodies;
}

void Physics::forget_outdated(ContactMemory& memory) const {
  for (PairMemory& m : memory) {
    if (!changed_.contains(m.first) && !changed_.contains(m.second)) continue;
    m.points_of_first.clear();
    m.points_of_second.clear();
    m.impulses.clear();
  }
}

Delta Physics::tick(World& world, bool under_beam, std::span<const KinematicBody> guided,
                    std::span<const BodyId> carried) {
  KERF_ASSERT(std::ranges::is_sorted(carried));
  if (count_bodies(world, carried).awake > 0) {
    update_caches(world, taking_part(world, carried), under_beam);
  } else if (world.spring()) {
    update_changed_masses(world, taking_part(world, carried), under_beam);
  }
  apply_spring(world, kTick);
  statistics_ = count_bodies(world, carried);
  if (statistics_.awake == 0) return {};
  statistics_.awake = 0;
  std::vector<MovingBody> bodies = moving_bodies(world, under_beam, carried);
  guide(bodies, guided);
  const bool all_rest =
      std::all_of(bodies.begin(), bodies.end(), [](const MovingBody& b) { return b.fixed || b.asleep; });
  if (all_rest) return {};

  KERF_ASSERT(joints_.has_value());
  const std::vector<BodyJoint> joints = joints_between(bodies, *joints_, world.joints());
  const ContactMemory& before = world.contact_memory();
  set_rolling_loss(bodies, joints, before, world.environment().gravity);
  ContactSearch search(bodies, joints, world.environment(), before);
  search.find();
  while (update_sleep(bodies, search.pairs(), joints, before, kTick)) {
    for (MovingBody& b : bodies) set_way(b, world.environment().gravity);
    search.find();
  }
  std::vector<TouchingPair> resting = take_resting(bodies, search.pairs());
  const Vec3& gravity = world.environment().gravity;
  const SpeedLimit limit(bodies, search.pairs(), joints,
                         kTick * glm::length(gravity) + kPressedOut * world.environment().metre);
  solve_contacts(bodies, search.pairs(), joints,
                 {.seconds = kTick, .gravity = gravity, .metre = world.environment().metre}, *solver_);
  limit.apply(bodies);
  stay_above_ground(bodies, world.environment());
  set_solved_way(bodies);
  statistics_.held = limit_penetration(bodies, search);
  count_quiet(bodies, search.pairs(), joints);
  for (const TouchingPair& p : search.pairs()) {
    if (p.second != TouchingPair::kGround) ++statistics_.pairs;
    statistics_.contacts += p.contacts.size();
    statistics_.crossed += p.memory.crossed > 0;
  }
  statistics_.candidates = search.candidates();
  ContactMemory memory = memory_after(bodies, before, search.pairs(), resting);
  pairs_ = std::move(search.pairs());
  remember_joints(bodies, joints, memory);
  forget_outdated(memory);
  world.set_contact_memory(std::move(memory));

  Delta delta;
  for (const MovingBody& b : bodies) {
    if (b.fixed || b.asleep) continue;
    delta.moved.push_back(b.id);
    ++statistics_.awake;
  }
  return delta;
}

bool has_pieces_off(const Body& body) { return !body.hidden && !pieces_off(body).empty(); }

void release_pieces(World& world, uint32_t generation, Delta& delta) {
  for (const BodyId id : world.ids()) {
    if (!has_pieces_off(world.body(id))) continue;
    update_mass_properties(world.body(id));
    const std::set<uint32_t> mating = mating_labels(world.body(id));
    for (const uint32_t label : pieces_off(world.body(id))) {
      const BodyId own = detach(world, {id, label}, generation, delta);
      Body &rest = world.body(id), &piece = world.body(own);
      piece.pinned = false;
      rest.motion.wake();
      piece.motion.wake();
      // A piece that turns on a joint was not cut off, and a knife leaves no room to push.
      if (piece.pieces[label].cut_off.faces > 0 && !mating.contains(label))
        push_apart(rest, piece, world.environment().metre);
    }
  }
}

}  // namespace kerf
