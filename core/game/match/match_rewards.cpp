#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "core/base/ids.h"
#include "core/game/match/match.h"
#include "core/game/vehicle/vehicle_dynamics.h"

namespace kerf {

namespace {

constexpr Ticks kLootTicks = static_cast<Ticks>(Match::kLootSeconds) * kTicksPerSecond;
constexpr double kEngineCharge = 0.25, kArmoured = 0.6;  // of the energy; of EnemySkill::min_vital
constexpr double kCooler = 0.75, kFaster = 1.3;          // factors of an upgrade
constexpr double kJump = 0.5;                            // s, of the shortest jump that counts

size_t index_of(Upgrade upgrade) { return static_cast<size_t>(upgrade) - 1; }

}  // namespace

// The upgrade of the car holds for each of its cars.
void Match::armour_player() { vehicles_[kPlayer].min_vital = armour_of_player(); }

// Returns EnemySkill::min_vital, less with each upgrade.
double Match::armour_of_player() const {
  double least = rules().skill(setup_.difficulty).min_vital;
  for (uint8_t n = 0; n < standing().upgrades[index_of(Upgrade::kArmour)]; ++n) least *= kArmoured;
  return least;
}

void Match::offer_loot() {
  using Kind = Event::Kind;
  for (const Event& e : tally_.events()) {
    if (e.by != kPlayer || e.vehicle == kPlayer || e.vehicle >= vehicles_.size()) continue;
    const auto offer = [&](Loot loot) {
      const auto known = [&](const LootPart& part) { return part.body == e.body; };
      if (std::ranges::none_of(loot_, known)) loot_.push_back({loot, e.body, standing().ticks + kLootTicks});
    };
    const VehicleDescription& what = vehicles_[e.vehicle].what();
    const bool engine =
        e.kind == Kind::kVitalLost && what.vitals[e.part].kind == VitalDescription::Kind::kEngine;
    if (e.kind == Kind::kWheelLost) offer(Loot::kWheel);
    if (e.kind == Kind::kTurretLost) offer(Loot::kLaser);
    if (engine) offer(Loot::kEngine);
    if (e.kind == Kind::kCleanPart) offer(Loot::kPlate);
  }
  std::erase_if(loot_, [&](const LootPart& part) {
    return part.until <= standing().ticks || !world().contains(part.body);
  });
}

void Match::take_loot() {
  if (!vehicles_[kPlayer].alive) return;
  const Vec3 own = middle_of(world().body(vehicles_[kPlayer].chassis));
  for (size_t i = 0; i < loot_.size(); ++i) {
    const LootPart part = loot_[i];
    const Vec3 at = middle_of(world().body(part.body));
    if (glm::distance(at, own) > kLootReach || !use_loot(part)) continue;
    loot_.erase(loot_.begin() + static_cast<std::ptrdiff_t>(i--));
    tally_.add_event({Event::Kind::kLooted, kPlayer, kPlayer, static_cast<size_t>(part.loot), part.body, at});
    if (vehicle_of(part.body) == Event::kNobody) world_.remove({part.body});
  }
}

// Returns false if the player has no use for the part.
bool Match::use_loot(const LootPart& part) {
  Vehicle& own = vehicles_[kPlayer];
  switch (part.loot) {
    case Loot::kWheel: {
      const auto lost = std::ranges::find(own.wheels, false, &Wheel::attached);
      if (lost == own.wheels.end()) return false;
      Delta change;
      replace_wheel(world_.world(), own, static_cast<size_t>(lost - own.wheels.begin()),
                    MatchWorld::kGeneration, change);
      world_.follow(std::move(change));
      return true;
    }
    case Loot::kEngine:
      if (own.gun.energy >= 1) return false;
      own.gun.energy = std::min(1.0, own.gun.energy + kEngineCharge);
      return true;
    case Loot::kLaser:
      return own.gun.works() && !std::exchange(own.gun.twin, true);
    case Loot::kPlate: {
      const double armoured = kArmoured * armour_of_player();
      return std::exchange(own.min_vital, armoured) > armoured;
    }
  }
  return false;
}

// A car that turns over in the air has not landed.
void Match::count_jump() {
  const Vehicle& own = vehicles_[kPlayer];
  const bool grounded = std::ranges::any_of(own.wheels, &Wheel::grounded);
  if (own.alive && !grounded && is_upright(world(), own)) {
    ++in_air_;
    return;
  }
  const double seconds = seconds_of_ticks(std::exchange(in_air_, 0));
  if (!own.alive || !grounded || seconds < kJump || !(rules().description.scores.air > 0)) return;
  tally_.award({Event::Kind::kJumped, kPlayer, kPlayer, 0, own.chassis,
                world().body(own.chassis).placement.position, seconds},
               std::round(rules().description.scores.air * seconds));
}

void Match::select_upgrade() {
  const uint8_t selected = vehicles_[kPlayer].controls.upgrade;
  if (standing().phase != Standing::Phase::kPause || upgraded_ || selected == 0) return;
  KERF_ASSERT(selected <= Controls::kUpgrades);
  upgraded_ = true;
  ++tally_.standing().upgrades[selected - 1u];
  tally_.add_event({Event::Kind::kUpgraded, kPlayer, kPlayer, selected});
}

// The upgrades apply to the player alone.
LaserRules Match::laser_of(size_t vehicle) const {
  LaserRules laser = rules().description.laser;
  if (vehicle != kPlayer) return laser;
  for (uint8_t i = 0; i < standing().upgrades[index_of(Upgrade::kCooling)]; ++i) laser.heating *= kCooler;
  for (uint8_t i = 0; i < standing().upgrades[index_of(Upgrade::kBattery)]; ++i) {
    laser.charge *= kFaster;
    laser.charge_driving *= kFaster;
  }
  return laser;
}

}  // namespace kerf
