#include "core/physics/physics.h"

#include <algorithm>
#include <limits>

#include "core/base/tick.h"
#include "core/physics/broad_phase.h"
#include "core/physics/pair_contacts.h"
#include "core/physics/pull.h"
#include "core/physics/sleep.h"

namespace kerf {

namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;
constexpr double kFullLengths = 1;  // m, the diagonal from which on the lengths of contact are used unscaled
constexpr ContactLengths kLengths;

// Where a body will be after a tick if nothing stops it.
Placement moved_on(const MovingBody& b, const Vec3& gravity) {
  if (b.fixed || b.asleep) return b.body->placement;
  const Motion& motion = b.body->motion;
  Placement principal = b.frame.in_world(b.body->placement);
  principal.position += kTick * (motion.velocity_at(principal.position, b.body->placement) + kTick * gravity);
  const glm::dquat turn(0, 0.5 * kTick * motion.spin);
  principal.orientation = glm::normalize(principal.orientation + turn * principal.orientation);
  return b.frame.body_at(principal);
}

// The bounds of a box under a rigid motion.
void add_box(const RigidMap& map, const Vec3& min, const Vec3& max, MovingBody& b) {
  const Vec3 middle = map(0.5 * (min + max)), half = 0.5 * (max - min);
  Vec3 extent(0);
  for (int column = 0; column < 3; ++column) extent += glm::abs(map.turn[column]) * half[column];
  b.min = glm::min(b.min, middle - extent);
  b.max = glm::max(b.max, middle + extent);
}

void set_way(MovingBody& b, const Vec3& gravity) {
  b.now = map_of(b.body->placement);
  b.next = map_of(moved_on(b, gravity));
  b.min = Vec3(std::numeric_limits<double>::infinity());
  b.max = -b.min;
  add_box(b.now, b.collider->min, b.collider->max, b);
  add_box(b.next, b.collider->min, b.collider->max, b);
  const double reach = kLengths.reach * b.scale;
  b.min -= reach;
  b.max += reach;
}

bool is_before(const PairMemory& m, std::pair<BodyId, BodyId> key) {
  return std::pair(m.first, m.second) < key;
}

const PairMemory* find(const ContactMemory& memory, BodyId first, BodyId second) {
  const auto at = std::lower_bound(memory.begin(), memory.end(), std::pair(first, second), is_before);
  return at != memory.end() && at->first == first && at->second == second ? &*at : nullptr;
}

// The contacts of a tick, and what is known of their pairs afterwards.
struct Found {
  std::vector<TouchingPair> pairs;
  ContactMemory memory;
  std::vector<size_t> memory_of_pair;
};

Found find_all(std::span<const MovingBody> bodies, std::span<const BodyJoint> joints,
               const Surroundings& around, const ContactMemory& before, TickFigures& figures) {
  Found found;
  const auto keep = [&](uint32_t first, uint32_t second, PairMemory memory, std::vector<Contact> contacts) {
    if (memory.crossed) ++figures.crossed;
    figures.contacts += contacts.size();
    if (contacts.empty()) remember_impulses(contacts, memory);
    if (!contacts.empty()) {
      found.memory_of_pair.push_back(found.memory.size());
      found.pairs.push_back({first, second, std::move(contacts)});
    }
    found.memory.push_back(std::move(memory));
  };
  for (const auto& [i, j] : near_pairs(bodies)) {
    if (are_joined(joints, i, j)) continue;
    const PairMemory* old = find(before, bodies[i].id, bodies[j].id);
    PairMemory memory = old ? *old : PairMemory{bodies[i].id, bodies[j].id, {}, {}, {}, {}};
    std::vector<Contact> contacts = find_contacts(bodies[i], bodies[j], kLengths, old == nullptr, memory);
    keep(i, j, std::move(memory), std::move(contacts));
    ++figures.pairs;
  }
  for (uint32_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].fixed || bodies[i].asleep) continue;
    const PairMemory* old = find(before, bodies[i].id, BodyId{});
    PairMemory memory = old ? *old : PairMemory{bodies[i].id, BodyId{}, {}, {}, {}, {}};
    std::vector<Contact> contacts = find_ground_contacts(bodies[i], around, kLengths, memory);
    if (!contacts.empty()) keep(i, TouchingPair::kGround, std::move(memory), std::move(contacts));
  }
  return found;
}

// Solves the pairs of which a body moves, and keeps their impulses. Returns these pairs.
std::vector<TouchingPair> solve(const World& world, std::span<MovingBody> bodies,
                                std::span<const BodyJoint> joints, Found& found) {
  const auto rests = [&](uint32_t i) {
    return i == TouchingPair::kGround || bodies[i].fixed || bodies[i].asleep;
  };
  std::vector<TouchingPair> pairs;
  std::vector<size_t> memory_of_pair;
  for (size_t i = 0; i < found.pairs.size(); ++i) {
    if (rests(found.pairs[i].first) && rests(found.pairs[i].second)) continue;
    pairs.push_back(std::move(found.pairs[i]));
    memory_of_pair.push_back(found.memory_of_pair[i]);
  }
  solve_contacts(bodies, pairs, joints, {.seconds = kTick, .gravity = world.surroundings().gravity});
  for (size_t i = 0; i < pairs.size(); ++i)
    remember_impulses(pairs[i].contacts, found.memory[memory_of_pair[i]]);
  return pairs;
}

// Pairs of sleeping bodies were not looked at; what is known of them stays.
void carry_over(std::span<const MovingBody> bodies, const ContactMemory& before, ContactMemory& memory) {
  const auto rests = [&](BodyId id) {
    const auto at = std::lower_bound(bodies.begin(), bodies.end(), id,
                                     [](const MovingBody& b, BodyId wanted) { return b.id < wanted; });
    return at != bodies.end() && at->id == id && (at->fixed || at->asleep);
  };
  for (const PairMemory& m : before) {
    if (rests(m.first) && (!m.second.valid() || rests(m.second))) memory.push_back(m);
  }
  std::sort(memory.begin(), memory.end(), [](const PairMemory& a, const PairMemory& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
}

}  // namespace

void Physics::follow(const Delta& delta) {
  if (delta.anew) colliders_.clear();
  if (!delta.bodies.empty() || delta.changes_bodies()) joints_.reset();
  for (const BodyDelta& b : delta.bodies) colliders_.erase(b.body);
  for (BodyId id : delta.came) colliders_.erase(id);
  for (BodyId id : delta.went) colliders_.erase(id);
  for (const Detached& d : delta.detached) {
    colliders_.erase(d.from);
    colliders_.erase(d.to);
  }
}

const Collider& Physics::collider_of(const World& world, BodyId id) {
  const auto [at, is_new] = colliders_.try_emplace(id);
  if (is_new) at->second = make_collider(world.body(id).mesh);
  return at->second;
}

std::vector<MovingBody> Physics::moving_bodies(World& world) {
  std::vector<MovingBody> bodies;
  for (const BodyId id : world.ids()) {
    Body& body = world.body(id);
    if (body.hidden || body.mesh.live_faces() == 0) continue;
    MovingBody& b = bodies.emplace_back();
    b.id = id;
    b.body = &body;
    b.collider = &collider_of(world, id);
    b.frame = rigid_frame(body);
    b.fixed = body.pinned || !(b.frame.mass > 0);
    b.asleep = body.motion.asleep;
    b.scale = std::min(1.0, glm::length(body.loaded.max - body.loaded.min) / kFullLengths);
    set_way(b, world.surroundings().gravity);
  }
  std::sort(bodies.begin(), bodies.end(),
            [](const MovingBody& a, const MovingBody& b) { return a.id < b.id; });
  return bodies;
}

Delta Physics::tick(World& world) {
  figures_ = {};
  pull(world, kTick);
  std::vector<MovingBody> bodies = moving_bodies(world);
  figures_.bodies = bodies.size();
  const bool all_rest =
      std::all_of(bodies.begin(), bodies.end(), [](const MovingBody& b) { return b.fixed || b.asleep; });
  if (all_rest) return {};

  if (!joints_) joints_ = held_joints(world);
  const std::vector<BodyJoint> joints = joints_between(bodies, *joints_, world.joints());
  const ContactMemory& before = world.contact_memory();
  Found found = find_all(bodies, joints, world.surroundings(), before, figures_);
  update_sleep(bodies, found.pairs, joints, before, kTick);
  pairs_ = solve(world, bodies, joints, found);
  count_quiet(bodies, joints);
  carry_over(bodies, before, found.memory);
  remember_joints(bodies, joints, found.memory);
  world.set_contact_memory(std::move(found.memory));

  Delta delta;
  for (const MovingBody& b : bodies) {
    if (b.fixed || b.asleep) continue;
    delta.moved.push_back(b.id);
    ++figures_.awake;
  }
  return delta;
}

}  // namespace kerf
