#include "core/game/match/match_world.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/cut/cut_step.h"
#include "core/physics/sleep.h"

namespace kerf {

JointFaces::JointFaces(const Joints& joints) {
  for (const Joint& joint : joints.all) {
    std::vector<bool>& carries = of_[joint.body];
    for (const JointSide& side : joint.sides) {
      if (side.faces.empty()) continue;
      if (carries.size() <= side.faces.back()) carries.resize(side.faces.back() + 1, false);
      for (const uint32_t f : side.faces) carries[f] = true;
    }
  }
}

const std::vector<bool>* JointFaces::of(const Body& body) const {
  const auto at = of_.find(body.loaded_as);
  return at == of_.end() ? nullptr : &at->second;
}

bool JointFaces::carries(const std::vector<bool>& carriers, const Body& body, FaceId f) {
  const FaceId loaded = body.loaded_face(body.loaded_base(f));
  return loaded.index < carriers.size() && carriers[loaded.index];
}

bool JointFaces::any_in(const Body& body) const {
  const std::vector<bool>* carriers = of(body);
  if (!carriers) return false;
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    if (body.mesh.is_live(FaceId(slot)) && carries(*carriers, body, FaceId(slot))) return true;
  }
  return false;
}

bool JointFaces::any_of(const Body& body, const std::vector<FaceId>& faces) const {
  const std::vector<bool>* carriers = of(body);
  return carriers &&
         std::any_of(faces.begin(), faces.end(), [&](FaceId f) { return carries(*carriers, body, f); });
}

namespace {

constexpr Ticks kAfterRemoval = 15, kAfterDetaching = 1;
constexpr size_t kLarge = 2'000;  // faces

constexpr Ticks kLookForJointsEvery = 10;  // if faces that carry joints were removed
constexpr size_t kSearch = 20'000;         // faces visited per tick by the search for separated pieces
constexpr size_t kMaxLoose = 200;          // bodies, including those of the arena
constexpr Ticks kClearEvery = kTicksPerSecond / 10;

}  // namespace

void StaleColliders::note(const Delta& change, Ticks now) {
  if (change.replaced) due_.clear();
  const auto make_due = [&](BodyId id, Ticks at) {
    Ticks& due = due_.try_emplace(id, at).first->second;
    due = std::min(due, at);
  };
  for (const BodyDelta& b : change.bodies) make_due(b.body, now + kAfterRemoval);
  for (const Detached& d : change.detached) make_due(d.from, now + kAfterDetaching);
  for (const Detached& d : change.detached) {
    if (!d.keeps_slots) continue;
    due_.erase(d.from);
    due_.erase(d.to);
  }
  for (const auto* list : {&change.created, &change.destroyed}) {
    for (const BodyId id : *list) due_.erase(id);
  }
}

std::vector<BodyId> StaleColliders::take_due(const World& world, Ticks now) {
  std::vector<BodyId> taken;
  auto large = due_.end();
  for (auto at = due_.begin(); at != due_.end();) {
    if (at->second > now) {
      ++at;
    } else if (world.body(at->first).mesh.live_faces() < kLarge) {
      taken.push_back(at->first);
      at = due_.erase(at);
    } else {
      if (large == due_.end() || at->second < large->second) large = at;
      ++at;
    }
  }
  if (large == due_.end()) return taken;
  taken.push_back(large->first);
  due_.erase(large);
  std::sort(taken.begin(), taken.end());
  return taken;
}

MatchWorld::MatchWorld(const Arena& arena) {
  Environment around;
  around.ground = arena.description.ground;
  world_.set_environment(around);
  for (const ModelBody& body : arena.bodies) arena_.push_back(add_body(world_, body, kGeneration));
  delta_.replaced = true;
}

std::optional<size_t> MatchWorld::of_arena(BodyId body) const {
  const auto at = std::find(arena_.begin(), arena_.end(), body);
  if (at == arena_.end()) return std::nullopt;
  return static_cast<size_t>(at - arena_.begin());
}

void MatchWorld::make_colliders(std::span<const BodyId> carried) {
  find_joints();
  physics_.prepare(world_, carried);
}

// Vehicles that are spawned and wheels that are replaced bring joints.
void MatchWorld::find_joints() {
  joint_faces_ = JointFaces(world_.joints());
  known_joints_ = world_.joints().all.size();
}

void MatchWorld::begin_tick(Ticks now) {
  now_ = now;
  delta_ = Delta{};
}

// Contacts are identified by the indices of points and chords of a collider.
void MatchWorld::renew_colliders() {
  const std::vector<BodyId> due = stale_colliders_.take_due(world_, now_);
  forget_contacts(world_, due);
  physics_.renew(due);
  if (now_ % kLookForJointsEvery != 0 || !std::exchange(joints_requested_, false)) return;
  physics_.forget_joints();
  hinges_requested_ = true;
}

void MatchWorld::move(std::span<const KinematicBody> guided, std::span<const BodyId> carried) {
  delta_.append(physics_.tick(world_, false, guided, carried));
}

void MatchWorld::keep_inside(const ArenaDescription& arena) {
  const Vec2 half = 0.5 * arena.size;
  for (const BodyId id : world_.ids()) {
    Body& body = world_.body(id);
    if (body.pinned || body.tree.leaf_count() == 0) continue;
    const Bounds box = body.bounds();
    const Vec3 centre = body.placement.to_world(0.5 * (box.min + box.max));
    const double size = 0.5 * glm::length(box.max - box.min);
    for (const auto& [axis, limit] : {std::pair{0, half.x - size}, {2, half.y - size}}) {
      const double over = std::abs(centre[axis]) - std::max(limit, 0.0);
      const double sign = centre[axis] < 0 ? -1 : 1;
      if (over <= 0) continue;
      body.placement.position[axis] -= sign * over;
      if (sign * body.motion.velocity[axis] > 0) body.motion.velocity[axis] *= -0.2;
    }
    const double under = arena.ground - size - centre.y;
    if (under > 0) body.placement.position.y += under + 0.1;
  }
}

void MatchWorld::record_placed(std::vector<BodyId> bodies) {
  Delta placed;
  placed.moved = std::move(bodies);
  delta_.append(std::move(placed));
}

// The part of a change that the physics receives immediately: created and removed bodies. Changes of faces
// follow later, and pieces without joints are omitted, because the physics builds colliders of unknown
// bodies by itself and need not search for joints that hold.
Delta MatchWorld::delta_for_physics(const Delta& change) const {
  Delta news = change;
  news.bodies.clear();
  std::erase_if(news.detached, [](const Detached& d) { return !d.keeps_slots; });
  const auto is_unknown = [&](BodyId id) { return !physics_.colliders().contains(id); };
  std::erase_if(news.destroyed, is_unknown);
  std::erase_if(news.created,
                [&](BodyId id) { return is_unknown(id) && !joint_faces_.any_in(world_.body(id)); });
  return news;
}

void MatchWorld::follow(Delta change) {
  if (change.empty()) return;
  if (world_.joints().all.size() != known_joints_) {
    find_joints();
    physics_.forget_joints();
  }
  forget_contacts(world_, change);
  stale_colliders_.note(change, now_);
  for (const BodyDelta& b : change.bodies)
    joints_requested_ = joints_requested_ || joint_faces_.any_of(world_.body(b.body), b.dead);
  physics_.follow(delta_for_physics(change));
  delta_.append(std::move(change));
}

void MatchWorld::remove(const std::vector<BodyId>& bodies) {
  if (bodies.empty()) return;
  for (const BodyId id : bodies) world_.remove(id);
  Delta change;
  change.destroyed = bodies;
  follow(std::move(change));
}

std::vector<Detached> MatchWorld::separate() {
  if (!is_settled(world_) || joints_requested(world_))
    follow(continue_separation(world_, kSearch, JointMode::kArticulated).delta);
  if (!is_settled(world_)) return {};
  Delta released;
  release_pieces(world_, kGeneration, released);
  std::vector<Detached> detached = released.detached;
  follow(std::move(released));
  return detach_hanging(std::move(detached));
}

bool MatchWorld::hangs(BodyId body, std::span<const HeldJoint> held) const {
  return std::ranges::any_of(held, [&](const HeldJoint& joint) {
    const BodyId first = joint.parts[0].body, second = joint.parts[1].body;
    return first != second && (first == body || second == body);
  });
}

// Returns the hanging and new pieces that no joint holds; the others hang from now on.
std::vector<Detached> MatchWorld::detach_hanging(std::vector<Detached> detached) {
  const bool asks = std::exchange(hinges_requested_, false) && !hanging_.empty();
  const auto may_hang = [&](const Detached& d) { return joint_faces_.any_in(world_.body(d.to)); };
  if (!asks && std::ranges::none_of(detached, may_hang)) return detached;
  std::vector<Detached> all = std::exchange(hanging_, {}), off;
  std::erase_if(all, [&](const Detached& d) { return !world_.contains(d.to); });
  all.insert(all.end(), detached.begin(), detached.end());
  LoadedBodies loaded;
  for (const Detached& d : all) loaded.push_back(world_.body(d.to).loaded_as);
  std::ranges::sort(loaded);
  const std::vector<HeldJoint> held = held_joints(world_, loaded);
  for (const Detached& d : all) (hangs(d.to, held) ? hanging_ : off).push_back(d);
  return off;
}

void MatchWorld::clear_debris(const std::function<bool(BodyId)>& stays) {
  if (now_ % kClearEvery != 0) return;
  struct Resting {
    double size;
    BodyId id;
  };
  std::vector<Resting> resting;
  size_t loose = 0;
  for (const BodyId id : world_.ids()) {
    const Body& body = world_.body(id);
    if (body.pinned || stays(id)) continue;
    ++loose;
    if (of_arena(id)) continue;
    const Bounds box = body.bounds();
    if (body.motion.asleep) resting.push_back({glm::length(box.max - box.min), id});
  }
  if (loose <= kMaxLoose) return;
  const size_t going = std::min(loose - kMaxLoose, resting.size());
  std::stable_sort(resting.begin(), resting.end(),
                   [](const Resting& a, const Resting& b) { return a.size < b.size; });
  std::vector<BodyId> ids;
  for (size_t i = 0; i < going; ++i) ids.push_back(resting[i].id);
  remove(ids);
}

void MatchWorld::cool() {
  constexpr Ticks kEvery = 30;
  for (const BodyId id : world_.ids()) {
    if ((id.slot + world_.clock()) % kEvery == 0)
      step_heat(world_, id, static_cast<double>(kEvery) / kTicksPerSecond);
  }
}

}  // namespace kerf
