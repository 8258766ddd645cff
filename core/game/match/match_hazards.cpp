#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/assert.h"
#include "core/base/ids.h"
#include "core/game/match/match.h"
#include "core/game/vehicle/vehicle_dynamics.h"

namespace kerf {

namespace {

constexpr Ticks kFallTicks = static_cast<Ticks>(Match::kFallSeconds) * kTicksPerSecond;
constexpr double kFallSpeed = 2;                          // m/s, of a part at the vehicle that it falls on
constexpr double kStrikeReach = 1.25, kHeavier = 0.0004;  // m, and m per kg of the part
constexpr double kMaxStrikeReach = 2;                     // m

constexpr double kBurstNear = 2, kBurstFar = 5;    // m, from a tank: full effect, no effect
constexpr double kBurstUp = 1.4, kBurstAside = 2;  // m/s, of vehicles
constexpr double kBurstDebris = 6;                 // m/s, of light bodies
constexpr double kBurstCrash = 6;                  // m/s above kCrash, that parts near a tank feel
constexpr double kBurstBreaks = 0.6;               // share of the effect from which joints break

// Returns the middle of the contacts of two bodies in the last tick [m, in the world]; nullopt without any.
std::optional<Vec3> touched_at(const Physics& physics, BodyId first, BodyId second) {
  const std::pair bodies(std::min(first, second), std::max(first, second));
  for (const TouchingPair& pair : physics.pairs()) {
    if (pair.memory.bodies() != bodies || pair.contacts.empty()) continue;
    Vec3 sum(0);
    for (const Contact& contact : pair.contacts) sum += contact.at;
    return sum / static_cast<double>(pair.contacts.size());
  }
  return std::nullopt;
}

// Returns the effect of a burst at a distance [m], from 1 near the tank to 0.
double burst_share(double distance) {
  return std::clamp((kBurstFar - distance) / (kBurstFar - kBurstNear), 0.0, 1.0);
}

}  // namespace

// Either side of a cut may be the one that falls.
void Match::follow_fall(const Detached& piece) {
  const auto cutter = cutters_.find(piece.from);
  if (cutter == cutters_.end()) return;
  const size_t by = cutter->second;
  for (const BodyId id : {piece.from, piece.to}) {
    if (!world().contains(id) || !world_.of_arena(world().body(id).loaded_as)) continue;
    const double mass = mass_of(world().body(id));
    if (mass < kFallingMass.low || mass > kFallingMass.high) continue;
    cutters_[id] = by;
    std::erase_if(falling_, [&](const FallingBody& known) { return known.body == id; });
    falling_.push_back({id, by, standing().elapsed() + kFallTicks, {}});
  }
}

std::vector<Motion> Match::falling_motions() const {
  std::vector<Motion> motions;
  for (const FallingBody& fall : falling_)
    motions.push_back(world().contains(fall.body) ? world().body(fall.body).motion : Motion{});
  return motions;
}

// `motions` are those of the falling bodies before the contact stopped them.
void Match::strike(const std::vector<Motion>& motions, const PlacementsBefore& before) {
  KERF_ASSERT(motions.size() == falling_.size());
  for (size_t i = 0; i < falling_.size(); ++i) {
    FallingBody& fall = falling_[i];
    if (!world().contains(fall.body)) continue;
    for (size_t v = 0; v < vehicles_.size(); ++v) {
      if (std::ranges::find(fall.struck, v) != fall.struck.end()) continue;
      Vehicle& vehicle = vehicles_[v];
      const auto touched = touched_at(physics(), fall.body, vehicle.chassis);
      if (!touched) continue;
      const Vec3 at = *touched;
      const Vec3 speed = motions[i].velocity_at(at, before.at(fall.body));
      if (glm::length(speed) < kFallSpeed) continue;
      fall.struck.push_back(v);
      const double mass = mass_of(world().body(fall.body));
      tally_.blame(v, fall.by);
      // Pieces of one prop score once for each vehicle.
      const auto score_of_fall = [&]() -> double {
        if (!vehicle.alive) return 0;
        const bool is_new =
            fall.by != kPlayer || struck_by_.emplace(world().body(fall.body).loaded_as, v).second;
        return is_new ? rules().description.scores.struck : 0;
      };
      tally_.add_event({Event::Kind::kStruck, v, fall.by, 0, fall.body, at, mass}, score_of_fall());
      const double reach = std::min(kMaxStrikeReach, kStrikeReach + kHeavier * mass);
      const Damage damage = knock_off(world(), vehicle, at, reach);
      pop_off_lost(v, damage);
      tally_.record_damage(world(), v, vehicle, damage);
      crash(v, at, (kCrash / glm::length(speed) + mass / vehicle.what().mass) * speed);
    }
  }
  std::erase_if(falling_, [&](const FallingBody& fall) {
    return fall.until <= standing().elapsed() || !world().contains(fall.body);
  });
}

void Match::burst_tanks() {
  for (const size_t v : std::exchange(bursting_, {})) {
    const Vehicle& vehicle = vehicles_[v];
    const Vec3 at = in_world(world(), vehicle, vehicle.model->tank_centre);
    tally_.add_event({Event::Kind::kTankBurst, v, tally_.last_cut_by(v), 0, vehicle.chassis, at},
                     rules().description.scores.tank);
    push_from(at, v);
  }
}

// The burst pushes vehicles and light bodies, overheats lasers, and breaks parts off the vehicles next to it.
void Match::push_from(const Vec3& at, size_t burst) {
  const size_t by = tally_.last_cut_by(burst);
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    Vehicle& vehicle = vehicles_[v];
    Body& chassis = world_.world().body(vehicle.chassis);
    if (chassis.tree.leaf_count() == 0) continue;
    const Vec3 way = middle_of(chassis) - at;
    const double share = v == burst ? 1 : burst_share(glm::length(way));
    if (!(share > 0)) continue;
    if (v != burst) tally_.blame(v, by);
    chassis.motion.wake();
    chassis.motion.velocity += share * (Vec3(0, kBurstUp, 0) + kBurstAside * horizontal(way));
    vehicle.gun.heat = std::max(vehicle.gun.heat, share);
    vehicle.gun.overheated = vehicle.gun.overheated || vehicle.gun.heat >= 1;
    if (share < kBurstBreaks) continue;
    const Bounds box = chassis.bounds();
    const Vec3 side = chassis.placement.to_world(glm::clamp(chassis.placement.to_body(at), box.min, box.max));
    const Vec3 away = way == Vec3(0) ? Vec3(0, 1, 0) : glm::normalize(way);
    crash(v, side, (kCrash + share * kBurstCrash) * away);
  }
  for (const BodyId id : world().ids()) {
    Body& body = world_.world().body(id);
    if (body.pinned || body.tree.leaf_count() == 0 || vehicle_of(id) != Event::kNobody) continue;
    const Vec3 way = middle_of(body) - at;
    const double share = burst_share(glm::length(way));
    if (!(share > 0) || mass_of(body) > kHeavyPart) continue;
    body.motion.wake();
    body.motion.velocity += share * kBurstDebris * (horizontal(way) + Vec3(0, 0.5, 0));
  }
}

}  // namespace kerf
