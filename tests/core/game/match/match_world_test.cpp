#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/game/match/match.h"
#include "core/game/vehicle/vehicle.h"
#include "tests/support/checkout.h"
#include "tests/support/free_parts.h"
#include "tests/support/game_files.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

TEST(Match, a_beam_never_cuts_the_vehicle_that_fires_it) {
  Match match({test::flat_rules(0, 0), 1, Difficulty::kNormal});
  Controls controls;
  controls.fire = true;
  controls.pitch = -10'000;
  const size_t faces = match.world().live_faces();
  for (int t = 0; t < 240; ++t) {
    controls.heading = 100 * t;
    match.tick(controls);
  }
  EXPECT_EQ(match.strokes(), 1u);
  EXPECT_EQ(match.world().live_faces(), faces);
}

// For how long parts that are free stay with the rest of their bodies in a match, and for how long nobody has
// noticed what a vehicle has lost. It looks every few ticks, because a search of all faces takes as long as a
// tick.
class Lateness {
 public:
  // To be called after every tick.
  void follow(const Match& match) {
    if (match.delta().replaced) *this = Lateness();
    unnoticed_.resize(match.vehicles().size(), 0);
    record_changes(match);
    if (match.standing().ticks % kEvery == 0) look(match, std::exchange(changed_, {}));
  }
  // Ticks that the first free part has been late.
  Ticks of_parts() const {
    Ticks longest = 0;
    for (const auto& [id, ticks] : free_) longest = std::max(longest, ticks);
    return longest;
  }
  Ticks of_losses() const { return *std::max_element(unnoticed_.begin(), unnoticed_.end()); }

 private:
  static constexpr Ticks kEvery = 3;

  void look(const Match& match, const std::set<BodyId>& changed) {
    follow_parts(match.world(), changed);
    for (size_t v = 0; v < match.vehicles().size(); ++v) {
      const std::vector<BodyId> bodies = all_bodies(match.vehicles()[v]);
      const auto changes = [&](BodyId id) { return changed.contains(id); };
      if (unnoticed_[v] > 0 || std::any_of(bodies.begin(), bodies.end(), changes))
        unnoticed_[v] = lost_more(match, v) ? unnoticed_[v] + kEvery : 0;
    }
  }

  // Notes of the bodies whose faces changed as which they were loaded.
  void record_changes(const Match& match) {
    const World& world = match.world();
    const auto add = [&](BodyId id) {
      if (world.contains(id)) changed_.insert(world.body(id).loaded_as);
    };
    for (const BodyDelta& b : match.delta().bodies) add(b.body);
    for (const Detached& d : match.delta().detached) {
      add(d.from);
      add(d.to);
    }
  }

  void follow_parts(const World& world, const std::set<BodyId>& changed) {
    std::map<BodyId, Ticks> now;
    for (const auto& [id, ticks] : free_) {
      if (world.contains(id) && !changed.contains(world.body(id).loaded_as)) now[id] = ticks + kEvery;
    }
    for (const BodyId family : changed) {
      for (const BodyId id : test::bodies_with_free_parts(world, family)) now[id] = free_[id] + kEvery;
    }
    free_ = std::move(now);
  }

  static bool lost_more(const Match& match, size_t v) {
    Vehicle copy = match.vehicles()[v];
    const Damage damage = assess_damage(match.world(), copy);
    return !damage.wheels.empty() || !damage.vitals.empty() || damage.turret || damage.barrel || damage.died;
  }

  std::set<BodyId> changed_;  // see record_changes, since it looked
  std::map<BodyId, Ticks> free_;
  std::vector<Ticks> unnoticed_;  // by vehicle
};

TEST(Match, parts_separate_and_vehicles_die_within_a_tenth_of_a_second) {
  const auto rules = load_rules(test::checkout() / "assets/games/standard.json");
  ASSERT_TRUE(rules) << rules.error().message;
  constexpr Ticks kLatest = kTicksPerSecond / 10;
  Ticks parts = 0, losses = 0;
  size_t pieces = 0, deaths = 0;
  for (uint64_t seed = 1; seed <= runs(10); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Match match({*rules, seed, Difficulty::kNormal});
    BotPlayer bot(match);
    Lateness late;
    for (Ticks t = 0; t < 20 * kTicksPerSecond && !match.standing().over(); ++t) {
      match.tick(bot.next(match));
      late.follow(match);
      parts = std::max(parts, late.of_parts());
      losses = std::max(losses, late.of_losses());
      ASSERT_LE(parts + losses, kLatest) << "tick " << t;
    }
    pieces += match.standing().pieces;
    deaths += match.standing().enemies_destroyed;
  }
  EXPECT_GE(pieces, 10 * runs(10));
  EXPECT_GT(deaths, 0u);
}

}  // namespace
}  // namespace kerf
