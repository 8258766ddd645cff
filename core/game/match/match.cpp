#include "core/game/match/match.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "core/base/random.h"
#include "core/game/vehicle/vehicle_dynamics.h"

namespace kerf {

namespace {

constexpr double kStartsAway = 30;  // m, length of the route of enemies to the player
constexpr double kGap = 2.5;        // m, between a new vehicle and other bodies

double length_of(const std::vector<Vec3>& way) {
  double length = 0;
  for (size_t i = 1; i < way.size(); ++i) length += glm::distance(way[i - 1], way[i]);
  return length;
}

bool has_room(const Vec3& place, const FreeSpace& space, std::span<const Disc> traffic) {
  if (space.spots() > 0 && !space.has_room(space.spot_at(place))) return false;
  return std::ranges::none_of(
      traffic, [&](const Disc& disc) { return glm::distance(disc.centre, place) < disc.radius + kGap; });
}

// Returns true if a vehicle fits between walls on even ground.
bool fits(const Vec3& place, double heading, const FreeSpace& space) {
  constexpr double kEnds = 1.8, kEven = 0.1;  // m, of the middle
  if (space.spots() == 0) return true;
  return std::ranges::all_of(std::array{-kEnds, -0.5 * kEnds, 0.0, 0.5 * kEnds, kEnds}, [&](double along) {
    const FreeSpace::Spot spot = space.spot_at(place + along * direction_of(wrapped(heading), 0));
    return space.has_room(spot) && std::abs(space.place_of(spot).y - place.y) <= kEven;
  });
}

constexpr double kLeaning = 0.35;  // cosine of the lean beyond which a vehicle is overturned
constexpr double kRoom = 2.5;      // m, around a vehicle
constexpr double kFreeSpeed = 3;   // m/s
constexpr double kLevel = 0.985;   // cosine of the largest lean of a place to put a vehicle, 10 degrees

constexpr double kUnstuckAway = 0.9;  // m

constexpr double kGetAway = 1.2;  // s, allowed to a vehicle that was put upright to make progress
constexpr double kLift = 0.35;    // m

bool wants_away(const Vehicle& vehicle) { return std::abs(vehicle.controls.throttle) > Controls::kFull / 5; }

bool is_overturned(const Body& chassis) {
  return (chassis.placement.orientation * Vec3(0, 1, 0)).y < kLeaning;
}

// A vehicle on all its wheels that has not tried both directions only stands in front of something.
bool is_caught(const Vehicle& vehicle) {
  return (vehicle.tried_ahead && vehicle.tried_back) ||
         std::any_of(vehicle.wheels.begin(), vehicle.wheels.end(),
                     [](const Wheel& w) { return w.attached && !w.grounded; });
}

void begin_to_count(const Body& chassis, Vehicle& vehicle) {
  vehicle.stuck_at = chassis.placement.position;
  vehicle.stuck_s = 0;
  vehicle.tried_ahead = vehicle.tried_back = false;
}

void count(const Body& chassis, Vehicle& vehicle) {
  const bool overturned = is_overturned(chassis), wants = wants_away(vehicle);
  const Vec3& place = chassis.placement.position;
  if (!vehicle.stuck_at || glm::distance(place, *vehicle.stuck_at) > kUnstuckAway)
    begin_to_count(chassis, vehicle);
  vehicle.overturned_s = overturned ? vehicle.overturned_s + kTick : 0;
  vehicle.stuck_s = std::max(0.0, vehicle.stuck_s + (overturned || wants ? kTick : -kTick));
  vehicle.tried_ahead |= wants && vehicle.controls.throttle > 0;
  vehicle.tried_back |= wants && vehicle.controls.throttle < 0;
  const double up = (chassis.placement.orientation * Vec3(0, 1, 0)).y;
  if (up > kLevel && glm::length(chassis.motion.velocity) > kFreeSpeed)
    vehicle.free_place = chassis.placement;
}

bool is_free(const World& world, const Vehicle& vehicle, const Vec3& place) {
  const Sight sight(world);
  for (const Sight::Near& near : sight.bodies()) {
    const bool in_the_way = !near.body->pinned && !vehicle.has(near.id) && near.radius > 0.5;
    if (in_the_way && glm::distance(near.centre, place) < near.radius + kRoom) return false;
  }
  return true;
}

// A place from which a vehicle can drive: where it last did, or the nearest place with room. A wedged one
// has tried the places nearby.
std::optional<Placement> way_out(const World& world, const Vehicle& vehicle, const FreeSpace& space,
                                 const Placement& from) {
  const bool wedged = vehicle.back_off.wedged;
  const auto serves = [&](const Vec3& place) {
    return glm::distance(place, from.position) > kUnstuckAway && is_free(world, vehicle, place);
  };
  if (!wedged && vehicle.free_place && serves(vehicle.free_place->position)) return vehicle.free_place;
  if (space.spots() == 0) return std::nullopt;
  constexpr double kFarthest = 20, kApart = 2, kWellAway = 6;  // m
  constexpr int kDirections = 12;
  for (double reach = wedged ? kWellAway : kApart; reach <= kFarthest; reach += kApart) {
    for (int i = 0; i < kDirections; ++i) {
      const Vec3 there = from.position + reach * direction_of(2 * kPi * i / kDirections, 0);
      const FreeSpace::Spot spot = space.spot_at(there);
      if (space.has_room(spot) && serves(space.place_of(spot)))
        return Placement{space.place_of(spot), from.orientation};
    }
  }
  return std::nullopt;
}

constexpr Ticks kLookAround = 6;                   // between updates of the traffic for drivers
constexpr double kImpact = 1.5;                    // m/s, change of velocity from which an impact is reported
constexpr double kThrown = 0.2, kThrownUp = 0.12;  // fractions of the change of velocity in a crash
constexpr double kCrumb = 0.0015;                  // m^2; smaller pieces burn up

// The enemies of the first wave do not aim at vital parts, those from the third wave on as their level says.
PilotSkill pilot_skill(const EnemySkill& skill, size_t wave) {
  const double burst = 0.25 + 1.25 * skill.fire * skill.fire, pause = 0.5 + 3 * (1 - skill.fire);
  const double vital = 0.1 + 0.5 * skill.fire * skill.fire, range = 14 + 14 * skill.fire;
  const double rising = std::min(1.0, 0.5 * static_cast<double>(wave));
  return {
      {skill.aim_error, burst, pause, rising * vital, 0, range}, skill.reaction, skill.distance, skill.speed};
}

// Returns true if a large prop stands at a place when a wave begins.
bool is_taken(const Arena& arena, const Vec3& place) {
  constexpr double kMiddle = 0.8, kAround = 0.5, kLarge = 3;  // m
  return std::ranges::any_of(arena.bodies, [&](const ModelBody& prop) {
    const Bounds box = prop.body.bounds();
    if (prop.body.pinned || glm::length(box.max - box.min) < kLarge) return false;
    const Vec3 at = prop.body.placement.to_body(place + Vec3(0, kMiddle, 0));
    return glm::all(glm::greaterThan(at, box.min - kAround)) &&
           glm::all(glm::lessThan(at, box.max + kAround));
  });
}

WaveStart first_wave(const MatchSetup& setup) {
  KERF_ASSERT(setup.rules);
  WaveStart start{{}, setup.rules->arena.description.player.placement(), 0, {}};
  start.standing.cars_left = setup.rules->description.cars - 1;
  return start;
}

// About the skill of a player in their second match.
PilotSkill skill() { return {{0.035, 1, 1, 0.45, 50, 60}, 0.2, 8, 0.85}; }

}  // namespace

std::vector<Start> starts_by_way(const ArenaDescription& arena, const FreeSpace& space, const Vec3& player) {
  std::vector<std::pair<double, Start>> starts;
  for (const Start& start : arena.enemies) {
    const std::vector<Vec3> way = find_route(space, {}, start.position, player);
    const double length = way.empty() ? glm::distance(start.position, player) : length_of(way);
    starts.emplace_back(std::abs(length - kStartsAway), start);
  }
  std::ranges::stable_sort(starts, {}, &std::pair<double, Start>::first);
  std::vector<Start> sorted;
  for (const auto& [off, start] : starts) sorted.push_back(start);
  return sorted;
}

std::optional<Placement> place_before(const Placement& vehicle, const FreeSpace& space,
                                      std::span<const Disc> traffic) {
  const double heading = heading_of(vehicle.orientation * Vec3(0, 0, 1));
  for (const double turn : {0.0, 0.35, -0.35, 0.7, -0.7, 1.4, -1.4, 2.4, -2.4, kPi}) {
    for (const double away : {7.0, 9.0, 11.0, 13.0}) {
      const Vec3 there = vehicle.position + away * direction_of(wrapped(heading + turn), 0);
      if (!has_room(there, space, traffic)) continue;
      const Vec3 at = space.spots() > 0 ? space.place_of(space.spot_at(there)) : there;
      // Across the view if there is room for it.
      for (const double across : {0.5 * kPi, 0.0}) {
        if (fits(at, heading + across, space)) return Placement{at, axis_angle({0, 1, 0}, heading + across)};
      }
    }
  }
  return std::nullopt;
}

Placement upright(const Placement& placement, double ground) {
  const double heading = heading_of(placement.orientation * Vec3(0, 0, 1));
  Vec3 position = placement.position;
  position.y = std::max(position.y, ground) + kLift;
  return {position, axis_angle({0, 1, 0}, heading)};
}

bool recover_vehicle(World& world, Vehicle& vehicle, const FreeSpace& space, const MatchTimes& times) {
  if (!vehicle.alive || vehicle.wheels_attached() == 0) return false;
  Body& chassis = world.body(vehicle.chassis);
  count(chassis, vehicle);
  const bool overturned = vehicle.overturned_s >= times.righting;
  const bool caught = vehicle.stuck_s >= times.stuck && is_caught(vehicle);
  const bool stuck = (caught || vehicle.back_off.wedged) && vehicle.can_drive();
  if (!overturned && !stuck) return false;
  const double ground = world.environment().ground.value_or(chassis.placement.position.y);
  // The centre of a vehicle on its roof is not at its origin.
  const Vec3 middle = chassis.placement.to_world(chassis.middle());
  const Placement here = upright({{middle.x, overturned ? middle.y : chassis.placement.position.y, middle.z},
                                  chassis.placement.orientation},
                                 ground);
  const std::optional<Placement> out = overturned ? std::nullopt : way_out(world, vehicle, space, here);
  chassis.placement = out ? upright(*out, ground) : here;
  chassis.motion = Motion{};
  vehicle.overturned_s = 0;
  vehicle.back_off = {};
  begin_to_count(chassis, vehicle);
  if (!out) vehicle.stuck_s = std::max(0.0, times.stuck - kGetAway);
  vehicle.gun.last.reset();  // otherwise the beam would sweep through everything in between
  place_carried(world, vehicle);
  return true;
}

Match::Match(MatchSetup setup) : Match(setup, first_wave(setup)) {}

Match::Match(MatchSetup setup, const WaveStart& start) : setup_(std::move(setup)) {
  KERF_ASSERT(setup_.rules);
  KERF_ASSERT(start.standing.wave < std::max<size_t>(1, rules().waves.size()));
  obstacles_ = Obstacles(rules().arena);
  space_ = FreeSpace(rules().arena);
  tally_ = Tally(rules().description.scores, start.standing, start.strokes);
  begin_wave(start);
}

double Match::seconds_left() const {
  return std::max(0.0, rules().description.times.match - seconds_of_ticks(standing().ticks));
}

void Match::begin_wave(const WaveStart& start) {
  world_ = MatchWorld(rules().arena);
  vehicles_.clear();
  pilots_.clear();
  enemies_.clear();
  numbers_.clear();
  trails_.clear();
  cutters_.clear();
  falling_.clear();
  struck_by_.clear();
  bursting_.clear();
  loot_.clear();
  in_air_ = 0;
  upgraded_ = false;
  asked_ = false;
  Delta created;
  vehicles_.push_back(
      add_vehicle(world_.world(), rules().player, start.player, MatchWorld::kGeneration, created));
  armour_player();
  add_enemies(start, created);
  traffic_ = find_traffic(world(), vehicles_);
  tally_.begin_wave(vehicles_.size());
  tally_.standing().wave = start.standing.wave;
  tally_.standing().phase = Standing::Phase::kFight;
  wave_start_ = {standing(), start.player, strokes(), start.out};
  tally_.add_event({Event::Kind::kWaveBegins, Event::kNobody, Event::kNobody, start.standing.wave});
  world_.make_colliders(carried());
}

void Match::add_enemies(const WaveStart& start, Delta& created) {
  const size_t wave = start.standing.wave;
  if (wave >= rules().waves.size()) return;
  const std::vector<Start> starts = starts_by_way(rules().arena.description, space_, start.player.position);
  KERF_ASSERT(!starts.empty());
  const uint64_t seed = hash_combine(hash_combine(setup_.seed, wave), standing().cars_left);
  for (size_t i = 0; i < rules().waves[wave].size(); ++i) {
    if (std::ranges::find(start.out, i) != start.out.end()) continue;
    Start start_of_this = starts[i % starts.size()];
    start_of_this.position +=
        (5.0 * static_cast<double>(i / starts.size())) * direction_of(start_of_this.heading, 0);
    const Placement at = start_of_this.placement();
    enemies_.push_back(vehicles_.size());
    numbers_.push_back(i);
    vehicles_.push_back(
        add_vehicle(world_.world(), rules().waves[wave][i], at, MatchWorld::kGeneration, created));
    pilots_.emplace_back(hash_combine(seed, i), pilot_skill(rules().skill(setup_.difficulty), wave));
  }
}

// Spawns a vehicle if the player requests one, up to a limit, and reports a request that it refuses.
void Match::spawn() {
  const bool asks = vehicles_[kPlayer].controls.spawn, asked = std::exchange(asked_, asks);
  if (!asks || asked || rules().spawns.empty()) return;
  const auto refuse = [&](size_t limit) {
    tally_.add_event({Event::Kind::kNotSpawned, kPlayer, Event::kNobody, limit});
  };
  if (vehicles_.size() > kMaxOthers) return refuse(kMaxOthers);
  traffic_ = find_traffic(world(), vehicles_);
  const std::optional<Placement> place =
      place_before(world().body(vehicles_[kPlayer].chassis).placement, space_, traffic_);
  if (!place) return refuse(0);
  const auto& model = rules().spawns[(vehicles_.size() - 1) % rules().spawns.size()];
  Delta created;
  vehicles_.push_back(add_vehicle(world_.world(), model, upright(*place, rules().arena.description.ground),
                                  MatchWorld::kGeneration, created));
  tally_.add_vehicle();
  thrown_.emplace_back(0);
  world_.follow(std::move(created));
}

size_t Match::vehicle_of(BodyId body) const {
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    if (vehicles_[v].has(body)) return v;
  }
  return Event::kNobody;
}

bool Match::is_wall(BodyId body) const {
  const std::optional<size_t> index = world_.of_arena(body);
  return index && !rules().arena.description.bodies[*index].cuttable;
}

DriverView Match::view(size_t vehicle, const Sight& sight) const {
  KERF_ASSERT(vehicle < vehicles_.size());
  static constexpr size_t kOnlyPlayer[] = {kPlayer};
  const std::span<const size_t> opponents =
      vehicle == kPlayer ? std::span<const size_t>(enemies_) : std::span<const size_t>(kOnlyPlayer);
  return {world(),
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
  world_.begin_tick(standing().elapsed());
  tally_.begin_tick();
  thrown_.assign(vehicles_.size(), Vec3(0));
  if (standing().over()) return go_on_afterwards();
  {
    const Sight sight(world());
    if (standing().ticks % kLookAround == 0) traffic_ = find_traffic(world(), vehicles_);
    take_controls(player, sight);
    steer_vehicles(sight);
  }
  spawn();
  world_.renew_colliders();
  PlacementsBefore before;
  move_bodies(before);
  fire_beams(before);
  separate();
  assess();
  recover();
  offer_loot();
  take_loot();
  count_jump();
  select_upgrade();
  world_.clear_debris([&](BodyId id) {
    return vehicle_of(id) != Event::kNobody ||
           std::ranges::any_of(loot_, [&](const LootPart& part) { return part.body == id; });
  });
  world_.cool();
  world_.world().pass(1);
  ++tally_.standing().ticks;
  judge();
}

void Match::steer_vehicles(const Sight& sight) {
  for (Vehicle& vehicle : vehicles_) {
    aim(world_.world(), vehicle);
    drive(world_.world(), vehicle, sight);
  }
}

void Match::go_on_afterwards() {
  if (settled()) return;
  ++tally_.standing().aftermath;
  for (Vehicle& vehicle : vehicles_) {
    vehicle.gun.firing = false;
    vehicle.controls.throttle = vehicle.controls.steer = 0;
  }
  steer_vehicles(Sight(world()));
  world_.renew_colliders();
  PlacementsBefore before;
  move_bodies(before);
  separate();
  world_.cool();
  world_.world().pass(1);
}

bool Match::is_disabled() const {
  const Vehicle& own = vehicles_[kPlayer];
  return own.alive && !own.gun.works();
}

void Match::take_controls(const Controls& player, const Sight& sight) {
  vehicles_[kPlayer].controls = backed_off(world(), vehicles_[kPlayer], player);
  for (size_t i = 0; i < enemies_.size(); ++i) {
    Vehicle& enemy = vehicles_[enemies_[i]];
    if (enemy.alive && !rules().description.targets)
      enemy.controls = pilots_[i].drive(view(enemies_[i], sight));
  }
  announce_beams();
  take_turns();
}

void Match::announce_beams() {
  for (const size_t v : enemies_) {
    Vehicle& enemy = vehicles_[v];
    Gun& gun = enemy.gun;
    const bool begins = enemy.controls.fire || gun.warning_s > 0;
    if (gun.announced || !begins) continue;
    if (!enemy.alive || !gun.works()) {
      gun.warning_s = 0;
      continue;
    }
    enemy.controls.fire = gun.warning_s >= kWarning;
    gun.warning_s += kTick;
    gun.announced = gun.warning_s >= kWarning + kFirstBeam;
  }
}

// Limits the number of enemies that fire at the same time: those that fire already, and then the first
// ones.
void Match::take_turns() {
  size_t left = rules().skill(setup_.difficulty).max_firing;
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
  for (const Vehicle& vehicle : vehicles_) all.push_back(world().body(vehicle.chassis).motion.velocity);
  return all;
}

// The vehicles as kinematic bodies for the physics: only heavy bodies stop one that drives.
std::vector<KinematicBody> Match::guided() const {
  std::vector<KinematicBody> all;
  for (const Vehicle& vehicle : vehicles_) {
    const double light = vehicle.alive ? kLightBody * vehicle.what().mass : 0;
    all.push_back({vehicle.chassis, is_upright(world(), vehicle), light});
  }
  return all;
}

std::vector<BodyId> Match::carried() const {
  std::vector<BodyId> all;
  for (const Vehicle& vehicle : vehicles_) {
    const std::vector<BodyId> bodies = carried_bodies(vehicle);
    all.insert(all.end(), bodies.begin(), bodies.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

void Match::move_bodies(PlacementsBefore& before) {
  for (const BodyId id : world().ids()) before[id] = world().body(id).placement;
  const std::vector<Vec3> velocities_before = velocities();
  const std::vector<Motion> falling_before = falling_motions();
  world_.move(guided(), carried());
  for (const Vehicle& vehicle : vehicles_) glide_along(world_.world(), vehicle, obstacles_);
  world_.keep_inside(rules().arena.description);
  record_impacts(velocities_before);
  if (!standing().over()) {
    strike(falling_before, before);
    burst_tanks();
  }
  for (const Vehicle& vehicle : vehicles_) {
    place_carried(world_.world(), vehicle);
    world_.record_placed(carried_bodies(vehicle));
  }
}

void Match::record_impacts(const std::vector<Vec3>& velocities_before) {
  const Vec3 falling = world().environment().gravity / static_cast<double>(kTicksPerSecond);
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    const Body& chassis = world().body(vehicles_[v].chassis);
    const Vec3 change = chassis.motion.velocity - velocities_before[v] - falling;
    const double size = glm::length(change);
    if (size < kImpact || chassis.tree.leaf_count() == 0) continue;
    const Vec3 at = pushed_at(chassis, change);
    tally_.add_event({Event::Kind::kImpact, v, Event::kNobody, 0, vehicles_[v].chassis, at, size});
    if (size >= kCrash) crash(v, at, change);
  }
}

// Throws the parts that a crash breaks off away from the obstacle.
void Match::crash(size_t vehicle, const Vec3& at, const Vec3& change) {
  if (!release_joints_near(world_.world(), vehicles_[vehicle], at, glm::length(change))) return;
  world_.record_released_joints();
  thrown_[vehicle] = kThrown * change + Vec3(0, kThrownUp * glm::length(change), 0);
}

void Match::fire_beams(const PlacementsBefore& before) {
  const Sight sight(world());
  const auto cuttable = [&](BodyId id) { return !is_wall(id); };
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    Vehicle& vehicle = vehicles_[v];
    const LaserRules laser = laser_of(v);
    const bool was_on = vehicle.gun.firing;
    if (trigger(vehicle, glm::length(world().body(vehicle.chassis).motion.velocity), laser))
      tally_.add_event(
          {Event::Kind::kOverheated, v, v, 0, {}, world().body(vehicle.chassis).placement.position});
    if (!vehicle.gun.firing) continue;
    if (!was_on && v == kPlayer) tally_.count_stroke();
    const auto follow = [&](const std::map<BodyId, StepResult>& cuts) {
      for (const auto& [id, cut] : cuts) {
        world_.follow(cut.delta);
        // A cut that failed may have removed parts before.
        if (cut.delta.replaced && vehicle_of(id) != Event::kNobody) tally_.blame(vehicle_of(id), v);
        if (cut.delta.removed_faces == 0) continue;
        tally_.record_cut(v, vehicle_of(id), id, world().body(id), cut);
        trails_.record(id, tally_.events().back().at, muzzle_pose(world(), vehicle).direction);
        if (vehicle_of(id) == Event::kNobody) cutters_[id] = v;
      }
    };
    // The second beam first: the first one sets the pose at the end of the tick.
    if (vehicle.gun.twin) follow(fire(world_.world(), vehicle, sight, cuttable, laser, before, kTwinAside));
    follow(fire(world_.world(), vehicle, sight, cuttable, laser, before));
  }
}

void Match::separate() {
  std::vector<BodyId> crumbs;
  for (const Detached& piece : world_.separate()) {
    Body& body = world_.world().body(piece.to);
    if (area_of(body) < kCrumb) {
      crumbs.push_back(piece.to);
      continue;
    }
    const size_t victim = vehicle_of(piece.from);
    const Vehicle* vehicle = victim != Event::kNobody ? &vehicles_[victim] : nullptr;
    if (vehicle) body.sheet = vehicle->what().body.sheet;
    if (!vehicle) follow_fall(piece);
    const bool is_thrown = vehicle && thrown_[victim] != Vec3(0);
    Vec3 across(0);
    if (is_thrown) {
      body.motion.velocity += thrown_[victim];
    } else if (world().contains(piece.from)) {
      Body& rest = world_.world().body(piece.from);
      across = vehicle ? part_at_cut(rest, body, trails_.of(piece.from), false)
                       : topple(rest, body, trails_.of(piece.from));
    }
    if (standing().over()) continue;
    tally_.record_piece(
        piece, body, victim, vehicle,
        vehicle && piece.from == vehicle->chassis && is_clean(body, vehicle->model->chassis.body), across);
  }
  world_.remove(crumbs);
}

void Match::assess() {
  if (!is_settled(world())) return;
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    if (!tally_.takes_assessment(v)) continue;
    const Damage damage = assess_damage(world_.world(), vehicles_[v]);
    pop_off_lost(v, damage);
    tally_.record_damage(world(), v, vehicles_[v], damage);
    if (damage.tank) bursting_.push_back(v);
  }
}

// Wheels fly off sideways, a laser upwards.
void Match::pop_off_lost(size_t vehicle, const Damage& damage) {
  const Vehicle& v = vehicles_[vehicle];
  World& world = world_.world();
  const Placement& chassis = world.body(v.chassis).placement;
  const CutTrail* trail = trails_.of(v.chassis);
  for (const size_t w : damage.wheels) {
    const double side = v.what().wheels[w].hub.x < 0 ? -1 : 1;
    pop_off(world.body(v.wheels[w].body), chassis.orientation * Vec3(side, 0, 0), trail);
  }
  const Vec3 up = chassis.orientation * Vec3(0, 1, 0);
  if (damage.turret) pop_off(world.body(v.gun.turret), up, trail);
  if (damage.barrel) pop_off(world.body(v.gun.barrel), up, trails_.of(v.gun.turret));
}

// A car that is moved has not jumped.
void Match::recover() {
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    const bool lies = is_overturned(world().body(vehicles_[v].chassis));
    if (!recover_vehicle(world_.world(), vehicles_[v], space_, rules().description.times)) continue;
    if (v == kPlayer) in_air_ = 0;
    Delta moved;
    moved.moved = all_bodies(vehicles_[v]);
    world_.follow(std::move(moved));
    tally_.add_event({Event::Kind::kRighted, v, Event::kNobody, lies ? Event::kFlipped : 0,
                      vehicles_[v].chassis, world().body(vehicles_[v].chassis).placement.position});
  }
}

void Match::judge() {
  using Phase = Standing::Phase;
  Standing& standing = tally_.standing();
  if (standing.phase == Phase::kDown && vehicles_[kPlayer].controls.give_up) standing.pause_left = 1;
  if (standing.phase == Phase::kPause || standing.phase == Phase::kDown) return end_pause();
  const bool gave_up = vehicles_[kPlayer].controls.give_up && is_disabled();
  const bool alive = vehicles_[kPlayer].alive && !gave_up, no_time = seconds_left() <= 0;
  if (no_time && alive && (rules().waves.empty() || rules().description.targets)) {
    standing.phase = Phase::kEnded;
    return;
  }
  if (!alive && !no_time && standing.cars_left > 0) return lose_car();
  if (!alive || no_time) {
    standing.phase = Phase::kLost;
    return tally_.add_event({Event::Kind::kLost});
  }
  const auto lives = [&](size_t v) { return vehicles_[v].alive; };
  if (rules().description.targets || enemies_.empty() || std::ranges::any_of(enemies_, lives)) return;
  tally_.add_event({Event::Kind::kWaveCleared, Event::kNobody, Event::kNobody, standing.wave});
  if (standing.wave + 1 == rules().waves.size()) {
    standing.phase = Phase::kWon;
    return tally_.add_event({Event::Kind::kWon});
  }
  standing.phase = Phase::kPause;
  standing.pause_left = pause();
}

Ticks Match::pause() const {
  return static_cast<Ticks>(rules().description.times.between_waves * kTicksPerSecond) + 1;
}

void Match::lose_car() {
  Standing& standing = tally_.standing();
  --standing.cars_left;
  standing.phase = Standing::Phase::kDown;
  standing.pause_left = pause();
  tally_.add_event({Event::Kind::kCarLost, kPlayer, Event::kNobody, standing.cars_left});
}

// The next wave begins at the place of the player. With another car the same wave restarts, without the
// disabled enemies if others are left; that of targets also without them, because it ends with its time.
void Match::end_pause() {
  Standing& standing = tally_.standing();
  if (--standing.pause_left > 0) return;
  WaveStart next = wave_start_;
  const bool other_car = standing.phase == Standing::Phase::kDown;
  for (size_t i = 0; i < enemies_.size(); ++i) {
    if (!vehicles_[enemies_[i]].alive) next.out.push_back(numbers_[i]);
  }
  const bool cleared = !enemies_.empty() && !rules().description.targets &&
                       next.out.size() == rules().waves[next.standing.wave].size();
  if (cleared && next.standing.wave + 1 == rules().waves.size()) {
    standing.phase = Standing::Phase::kWon;
    return tally_.add_event({Event::Kind::kWon});
  }
  if (cleared) {
    ++next.standing.wave;
    next.out.clear();
  }
  const Body& chassis = world().body(vehicles_[kPlayer].chassis);
  const Placement start = rules().arena.description.player.placement();
  next.player = other_car ? start : upright(chassis.placement, rules().arena.description.ground);
  if (is_taken(rules().arena, next.player.position)) next.player = start;
  begin_wave(next);
}

BotPlayer::BotPlayer(const Match& match) : pilot_(mix64(match.setup().seed ^ 0x626f74), skill()) {}

Controls BotPlayer::next(const Match& match) {
  const Sight sight(match.world());
  Controls controls = pilot_.drive(match.view(Match::kPlayer, sight));
  controls.give_up = match.is_disabled();
  return controls;
}

}  // namespace kerf
