#include "core/base/assert.h"
#include "core/cut/thermal_step.h"
#include "core/game/match/match.h"

#include <algorithm>
#include <utility>

#include "core/base/angle.h"
#include "core/base/hash.h"
#include "core/game/laser/gun.h"
#include "core/game/vehicle/drive.h"
#include "core/game/vehicle/glide.h"
#include "core/game/vehicle/vehicle_bodies.h"
#include "core/physics/forget_contacts.h"
#include "core/world/heat_flow.h"

namespace kerf {

namespace {

constexpr Ticks kLookForJointsEvery = 10;  // where faces that carry some are gone
constexpr Ticks kLookAround = 6;           // after which drivers look where others are
constexpr double kImpact = 1.5;            // m/s, from which on a change of velocity is told

PilotSkill pilot_skill(const EnemySkill& skill) {
  const double burst = 0.25 + 1.25 * skill.fire * skill.fire, pause = 0.5 + 3 * (1 - skill.fire);
  const double vital = 0.1 + 0.5 * skill.fire * skill.fire, range = 14 + 14 * skill.fire;
  return {{skill.aim_error, burst, pause, vital, 0, range}, skill.reaction, skill.distance, skill.speed};
}

// The starts of the enemies, those farthest from a place first.
std::vector<Start> starts_by_distance(const ArenaDescription& arena, const Vec3& from) {
  std::vector<Start> starts = arena.enemies;
  std::stable_sort(starts.begin(), starts.end(), [&](const Start& a, const Start& b) {
    return glm::distance(a.position, from) > glm::distance(b.position, from);
  });
  return starts;
}

// Takes the bodies that vehicles carry out of the physics for as long as it exists: they neither touch
// anything nor have a mass of their own.
class CarriedAside {
 public:
  CarriedAside(World& world, const std::vector<Vehicle>& vehicles) : world_(world) {
    for (const Vehicle& vehicle : vehicles) {
      const std::vector<BodyId> carried = carried_bodies(vehicle);
      ids_.insert(ids_.end(), carried.begin(), carried.end());
    }
    for (const BodyId id : ids_) world_.body(id).hidden = true;
  }
  ~CarriedAside() {
    for (const BodyId id : ids_) world_.body(id).hidden = false;
  }
  CarriedAside(const CarriedAside&) = delete;
  CarriedAside& operator=(const CarriedAside&) = delete;

 private:
  World& world_;
  std::vector<BodyId> ids_;
};

WaveStart first_wave(const MatchSetup& setup) {
  KERF_ASSERT(setup.rules);
  return {{}, setup.rules->arena.description.player.placement(), 0};
}

}  // namespace

Match::Match(MatchSetup setup) : Match(setup, first_wave(setup)) {}

Match::Match(MatchSetup setup, const WaveStart& start) : setup_(std::move(setup)), strokes_(start.strokes) {
  KERF_ASSERT(setup_.rules);
  KERF_ASSERT(start.standing.wave < std::max<size_t>(1, rules().waves.size()));
  obstacles_ = Obstacles(rules().arena);
  space_ = FreeSpace(rules().arena);
  standing_ = start.standing;
  begin_wave(start.standing.wave, start.player);
}

double Match::seconds_left() const {
  return std::max(0.0, rules().description.times.match - seconds_of_ticks(standing_.ticks));
}

void Match::begin_wave(size_t wave, const Placement& player) {
  const ArenaDescription& arena = rules().arena.description;
  world_ = World();
  physics_ = Physics();
  stale_colliders_ = StaleColliders();
  Surroundings around;
  around.ground = arena.ground;
  world_.set_surroundings(around);
  arena_.clear();
  for (const ModelBody& body : rules().arena.bodies) arena_.push_back(add_body(world_, body, kGeneration));
  vehicles_.clear();
  pilots_.clear();
  enemies_.clear();
  Delta came;
  vehicles_.push_back(add_vehicle(world_, rules().player, player, kGeneration, came));
  if (wave < rules().waves.size()) {
    const std::vector<Start> starts = starts_by_distance(arena, player.position);
    for (size_t i = 0; i < rules().waves[wave].size(); ++i) {
      Start start = starts[i % starts.size()];
      start.position += (5.0 * static_cast<double>(i / starts.size())) * direction_of(start.heading, 0);
      enemies_.push_back(vehicles_.size());
      vehicles_.push_back(add_vehicle(world_, rules().waves[wave][i], start.placement(), kGeneration, came));
      pilots_.emplace_back(hash_combine(hash_combine(setup_.seed, wave), i),
                           pilot_skill(rules().skill(setup_.difficulty)));
    }
  }
  joint_faces_ = JointFaces(world_.joints());
  lost_joint_faces_.clear();
  records_.assign(vehicles_.size(), Record{});
  traffic_ = find_traffic(world_, vehicles_);
  standing_.wave = wave;
  standing_.phase = Standing::Phase::kFight;
  wave_start_ = {standing_, player, strokes_};
  delta_ = Delta{};
  delta_.anew = true;
  tell({Event::Kind::kWaveBegins, Event::kNobody, Event::kNobody, wave});
  make_colliders();
}

// All of them take as long as twenty ticks, so that a match begins with those that a tick of a copy makes.
void Match::make_colliders() {
  World copy = world_;
  const CarriedAside aside(copy, vehicles_);
  physics_.tick(copy, false, guided());
}

size_t Match::vehicle_of(BodyId body) const {
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    if (vehicles_[v].has(body)) return v;
  }
  return Event::kNobody;
}

bool Match::is_wall(BodyId body) const {
  const auto at = std::find(arena_.begin(), arena_.end(), body);
  return at != arena_.end() &&
         !rules().arena.description.bodies[static_cast<size_t>(at - arena_.begin())].cuttable;
}

DriverView Match::view(size_t vehicle, const Sight& sight) const {
  static constexpr size_t kOnlyPlayer[] = {kPlayer};
  const std::span<const size_t> opponents =
      vehicle == kPlayer ? std::span<const size_t>(enemies_) : std::span<const size_t>(kOnlyPlayer);
  return {world_,
          sight,
          vehicles_,
          vehicle,
          opponents,
          [this](BodyId id) { return is_wall(id); },
          rules().arena.description.size,
          rules().description.laser.range,
          space_,
          traffic_};
}

void Match::tick(const Controls& player) {
  delta_ = Delta{};
  events_.clear();
  if (standing_.over()) return;
  {
    const Sight sight(world_);
    if (standing_.ticks % kLookAround == 0) traffic_ = find_traffic(world_, vehicles_);
    take_controls(player, sight);
    for (Vehicle& vehicle : vehicles_) {
      aim(world_, vehicle);
      drive(world_, vehicle, sight);
    }
  }
  renew_colliders();
  PlacementsBefore before;
  move_bodies(before);
  fire_beams(before);
  separate();
  assess();
  recover();
  clear_debris();
  cool_bodies();
  world_.pass(1);
  ++standing_.ticks;
  judge();
}

// Heat flows in each body for some ticks at once, and not in all bodies in the same tick.
void Match::cool_bodies() {
  constexpr Ticks kEvery = 30;
  for (const BodyId id : world_.ids()) {
    if ((id.slot + world_.clock()) % kEvery == 0)
      let_heat_flow(world_, id, static_cast<double>(kEvery) / kTicksPerSecond);
  }
}

void Match::take_controls(const Controls& player, const Sight& sight) {
  vehicles_[kPlayer].controls = player;
  for (size_t i = 0; i < enemies_.size(); ++i) {
    Vehicle& enemy = vehicles_[enemies_[i]];
    if (enemy.alive) enemy.controls = pilots_[i].drive(view(enemies_[i], sight));
  }
  take_turns();
}

// Only so many enemies fire at the same time: those that fire already, and then the first ones.
void Match::take_turns() {
  size_t left = rules().skill(setup_.difficulty).at_once;
  for (const bool firing : {true, false}) {
    for (const size_t v : enemies_) {
      Vehicle& enemy = vehicles_[v];
      if (!enemy.alive || !enemy.controls.fire || enemy.gun.firing != firing) continue;
      if (left > 0) {
        --left;
      } else {
        enemy.controls.fire = false;
      }
    }
  }
}

std::vector<Vec3> Match::velocities() const {
  std::vector<Vec3> all;
  for (const Vehicle& vehicle : vehicles_) all.push_back(world_.body(vehicle.chassis).motion.velocity);
  return all;
}

// The vehicles as the physics shall treat them: only what is heavy stops one that drives.
std::vector<Guided> Match::guided() const {
  std::vector<Guided> all;
  for (const Vehicle& vehicle : vehicles_) {
    const double light = vehicle.alive ? kLightBody * vehicle.what().mass : 0;
    all.push_back({vehicle.chassis, is_upright(world_, vehicle), light});
  }
  return all;
}

void Match::move_bodies(PlacementsBefore& before) {
  for (const BodyId id : world_.ids()) before[id] = world_.body(id).placement;
  const std::vector<Vec3> velocities_before = velocities();
  {
    const CarriedAside aside(world_, vehicles_);
    delta_.append(physics_.tick(world_, false, guided()));
  }
  for (const Vehicle& vehicle : vehicles_) glide_along(world_, vehicle, obstacles_);
  keep_inside();
  note_impacts(velocities_before);
  for (const Vehicle& vehicle : vehicles_) {
    place_carried(world_, vehicle);
    const std::vector<BodyId> carried = carried_bodies(vehicle);
    Delta moved;
    moved.moved = carried;
    delta_.append(std::move(moved));
  }
}

void Match::note_impacts(const std::vector<Vec3>& velocities_before) {
  const Vec3 falling = world_.surroundings().gravity / static_cast<double>(kTicksPerSecond);
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    const Body& chassis = world_.body(vehicles_[v].chassis);
    const double change = glm::length(chassis.motion.velocity - velocities_before[v] - falling);
    if (change < kImpact) continue;
    tell({Event::Kind::kImpact, v, Event::kNobody, 0, vehicles_[v].chassis, chassis.placement.position,
          change});
  }
}

// Nothing leaves the arena: its edge is a wall that takes away the motion against it.
void Match::keep_inside() {
  const ArenaDescription& arena = rules().arena.description;
  const Vec2 half = 0.5 * arena.size;
  for (const BodyId id : world_.ids()) {
    Body& body = world_.body(id);
    if (body.pinned || body.tree.leaf_count() == 0) continue;
    const AabbTree::Box box = body.tree.bounds();
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

// A delta without faces makes a collider anew, and leaves what is known of joints. Contacts are known by the
// numbers of points and chords of a collider.
void Match::renew_colliders() {
  Delta stale, renewed;
  for (const BodyId id : stale_colliders_.take_due(world_, standing_.ticks)) {
    stale.bodies.emplace_back().body = id;
    renewed.moved.push_back(id);
  }
  forget_contacts(world_, renewed);
  if (standing_.ticks % kLookForJointsEvery == 0) stale.moved = std::exchange(lost_joint_faces_, {});
  physics_.follow(stale);
}

// Which bodies came and went. Of their faces the physics is told later, and of pieces without joints not at
// all: it makes the colliders of bodies that it does not know, and need not look for the joints that hold.
Delta Match::news_for_physics(const Delta& change) const {
  Delta news = change;
  if (news.anew) return news;
  news.bodies.clear();
  std::erase_if(news.detached, [](const Detached& d) { return !d.carries_on; });
  const auto is_unknown = [&](BodyId id) { return !physics_.colliders().contains(id); };
  std::erase_if(news.went, is_unknown);
  std::erase_if(news.came,
                [&](BodyId id) { return is_unknown(id) && !joint_faces_.any_in(world_.body(id)); });
  return news;
}

void Match::follow(Delta change) {
  if (change.empty()) return;
  forget_contacts(world_, change);
  stale_colliders_.note(change, standing_.ticks);
  for (const BodyDelta& b : change.bodies) {
    if (joint_faces_.any_of(world_.body(b.body), b.gone)) lost_joint_faces_.push_back(b.body);
  }
  physics_.follow(news_for_physics(change));
  delta_.append(std::move(change));
}

}  // namespace kerf
