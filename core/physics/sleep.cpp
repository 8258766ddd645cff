#include "core/physics/sleep.h"

#include <algorithm>
#include <vector>

#include "core/base/assert.h"
#include "core/base/containers.h"
#include "core/base/ids.h"
#include "core/world/rigid_body.h"

namespace kerf {

namespace {

constexpr double kSlow = 0.4;         // m/s
constexpr double kSlowSpin = 1.0;     // rad/s
constexpr double kSlowRim = 0.4;      // max speed of points due to the spin of a small body [m/s]
constexpr double kSlowOnJoint = 0.1;  // share of these limits
constexpr uint32_t kQuietTicks = kTicksPerSecond / 2;
constexpr int kWakeSteps = 2;     // contacts over which restlessness spreads, from body to touching body
constexpr double kTouch = 0.001;  // distance of skins that count as touching [m]

Vec3 velocity_at(const MovingBody& b, const Vec3& p) {
  if (b.fixed || b.asleep) return Vec3(0);
  return b.body->motion.velocity_at(p, b.body->placement);
}

// Returns true if two bodies touch, or will before the end of the tick.
bool touch(std::span<const MovingBody> bodies, const TouchingPair& pair, double seconds) {
  const MovingBody &a = bodies[pair.first], &b = bodies[pair.second];
  const double near = kTouch * std::min(a.scale, b.scale);
  return std::any_of(pair.contacts.begin(), pair.contacts.end(), [&](const Contact& c) {
    const double closing = -glm::dot(velocity_at(a, c.at) - velocity_at(b, c.at), c.normal);
    return c.distance - seconds * std::max(closing, 0.0) < near;
  });
}

using TouchingEdges = std::vector<std::pair<uint32_t, uint32_t>>;

// Returns the pairs of bodies that can move and touch each other.
TouchingEdges touching(std::span<const MovingBody> bodies, std::span<const TouchingPair> pairs,
                       const ContactMemory& memory, double seconds) {
  TouchingEdges edges;
  const auto add = [&](uint32_t a, uint32_t b) {
    if (!bodies[a].fixed && !bodies[b].fixed) edges.emplace_back(a, b);
  };
  for (const TouchingPair& pair : pairs) {
    if (pair.second != TouchingPair::kGround && touch(bodies, pair, seconds)) add(pair.first, pair.second);
  }
  for (const PairMemory& m : memory) {
    const uint32_t a = index_of(bodies, m.first), b = index_of(bodies, m.second);
    if (!m.touching || std::max(a, b) == bodies.size()) continue;
    if (bodies[a].asleep && bodies[b].asleep) add(a, b);
  }
  return edges;
}

// Groups of bodies that joints connect; a group is awake if one of its bodies is.
class AwakeGroups {
 public:
  AwakeGroups(std::span<const MovingBody> bodies, std::span<const BodyJoint> joints)
      : groups_(bodies.size()), awake_(bodies.size(), false) {
    for (const BodyJoint& j : joints) {
      KERF_ASSERT(std::max(j.first, j.second) < bodies.size());
      if (!bodies[j.first].fixed && !bodies[j.second].fixed) groups_.unite(j.first, j.second);
    }
  }
  void wake(uint32_t i) { awake_[groups_.find(i)] = true; }
  bool is_awake(uint32_t i) { return awake_[groups_.find(i)]; }

  void wake_neighbours(const TouchingEdges& edges) {
    std::vector<uint32_t> woken;
    for (const auto& [a, b] : edges) {
      if (is_awake(a) != is_awake(b)) woken.push_back(is_awake(a) ? b : a);
    }
    for (const uint32_t i : woken) wake(i);
  }

 private:
  UnionFind groups_;
  std::vector<bool> awake_;  // by the representative of the group
};

// Returns the bodies whose contacts a change ends.
std::vector<BodyId> changed_bodies(const World& world, const Delta& delta) {
  if (delta.replaced || delta.environment) return world.ids();
  std::vector<BodyId> ids;
  for (const BodyDelta& b : delta.bodies) {
    if (!b.added.empty() || !b.dead.empty()) ids.push_back(b.body);
  }
  for (const auto* list : {&delta.created, &delta.destroyed, &delta.moved, &delta.mass_changed,
                           &delta.visibility_changed, &delta.pinned, &delta.joined})
    ids.insert(ids.end(), list->begin(), list->end());
  for (const Detached& d : delta.detached) ids.insert(ids.end(), {d.from, d.to});
  return ids;
}

void wake(World& world, BodyId id) {
  if (world.contains(id)) world.body(id).motion.wake();
}

}  // namespace

bool update_sleep(std::span<MovingBody> bodies, std::span<const TouchingPair> pairs,
                  std::span<const BodyJoint> joints, const ContactMemory& memory, double seconds) {
  KERF_ASSERT(seconds > 0);
  AwakeGroups groups(bodies, joints);
  for (uint32_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].fixed && bodies[i].body->motion.quiet < kQuietTicks) groups.wake(i);
  }
  const TouchingEdges edges = touching(bodies, pairs, memory, seconds);
  for (int step = 0; step < kWakeSteps; ++step) groups.wake_neighbours(edges);
  bool woke = false;
  for (uint32_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].fixed) continue;
    Motion& motion = bodies[i].body->motion;
    const bool slept = motion.asleep;
    motion.asleep = bodies[i].asleep = !groups.is_awake(i);
    if (motion.asleep) motion.velocity = motion.spin = Vec3(0);
    woke = woke || (slept && !motion.asleep);
  }
  return woke;
}

void count_quiet(std::span<MovingBody> bodies, std::span<const TouchingPair> pairs,
                 std::span<const BodyJoint> joints) {
  std::vector<double> limit(bodies.size(), 1);  // factor of the speed limits
  for (const BodyJoint& joint : joints) {
    KERF_ASSERT(joint.joint != nullptr);
    if (joint.joint->kind != Joint::Kind::kWeld) limit[joint.first] = limit[joint.second] = kSlowOnJoint;
  }
  for (const TouchingPair& pair : pairs) {
    if (pair.memory.crossed > 0 && !pair.contacts.empty()) limit[pair.first] = limit[pair.second] = 0;
  }
  for (uint32_t i = 0; i < bodies.size(); ++i) {
    MovingBody& b = bodies[i];
    if (b.fixed || b.asleep) continue;
    Motion& motion = b.body->motion;
    const Vec3 centre = b.body->placement.to_world(b.frame.centre);
    KERF_ASSERT(b.metre > 0);
    const double radius = 0.5 * glm::length(b.collider->bounds.max - b.collider->bounds.min);
    const double slow_spin = std::max(kSlowSpin, kSlowRim * b.metre / radius);
    const bool slow =
        glm::length(motion.velocity_at(centre, b.body->placement)) < limit[i] * kSlow * b.metre &&
        glm::length(motion.spin) < limit[i] * slow_spin;
    motion.quiet = slow ? std::min(motion.quiet + 1, kQuietTicks) : 0;
  }
}

void forget_details(World& world) {
  const std::vector<NearPair> pairs = known_pairs(world);
  set_known_pairs(world, pairs);
}

void forget_contacts(World& world, const Delta& delta) {
  forget_contacts(world, changed_bodies(world, delta));
}

void forget_contacts(World& world, std::vector<BodyId> changed) {
  KERF_ASSERT(std::all_of(changed.begin(), changed.end(), [](BodyId id) { return id.valid(); }));
  std::sort(changed.begin(), changed.end());
  const auto has_changed = [&](BodyId id) {
    return id.valid() && std::binary_search(changed.begin(), changed.end(), id);
  };
  for (const BodyId id : changed) wake(world, id);
  const auto ends = [&](const PairMemory& m) { return has_changed(m.first) || has_changed(m.second); };
  const ContactMemory& memory = world.contact_memory();
  if (std::none_of(memory.begin(), memory.end(), ends)) return;
  ContactMemory kept;
  for (const PairMemory& m : memory) {
    if (!ends(m)) {
      kept.push_back(m);
      continue;
    }
    wake(world, m.first);
    wake(world, m.second);
  }
  world.set_contact_memory(std::move(kept));
}

}  // namespace kerf
