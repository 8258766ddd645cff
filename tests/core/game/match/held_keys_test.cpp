#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/base/deterministic_math.h"
#include "core/game/match/match.h"
#include "tests/support/checkout.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

std::shared_ptr<const Rules> yard_without_enemies() {
  const auto loaded = load_rules(test::checkout() / "assets/games/standard.json");
  if (!loaded) return nullptr;
  auto rules = std::make_shared<Rules>(**loaded);
  rules->waves.clear();
  return rules;
}

// The longest times (s) for which the player stays within a metre although a key is held.
struct Standstill {
  double unhelped = 0;  // without driving out by itself or being lifted
  double all = 0;
};

Standstill longest_standstill(const std::shared_ptr<const Rules>& rules, const Start& from,
                              const Controls& held, double seconds) {
  WaveStart start;
  start.player = from.placement();
  Match match({rules, 1, Difficulty::kNormal}, start);
  Vec3 anchor = start.player.position;
  Ticks since = 0, helped = 0;
  Standstill longest;
  for (Ticks t = 0; t < static_cast<Ticks>(seconds * kTicksPerSecond); ++t) {
    match.tick(held);
    const Vehicle& own = match.vehicles()[Match::kPlayer];
    const Vec3 at = match.world().body(own.chassis).placement.position;
    if (glm::distance(anchor, at) > 1) {
      anchor = at;
      since = helped = t;
    }
    const auto righted = [](const Event& e) { return e.kind == Event::Kind::kRighted; };
    if (own.controls.throttle * held.throttle < 0 || std::ranges::any_of(match.events(), righted)) helped = t;
    longest.unhelped = std::max(longest.unhelped, seconds_of_ticks(t - helped));
    longest.all = std::max(longest.all, seconds_of_ticks(t - since));
  }
  return longest;
}

// From all starts of the yard, with one direction held to the end, straight and in a curve.
TEST(Match, holding_one_direction_frees_the_vehicle_within_three_seconds) {
  const auto rules = yard_without_enemies();
  ASSERT_TRUE(rules);
  const ArenaDescription& yard = rules->arena.description;
  std::vector<Start> starts = yard.enemies;
  starts.insert(starts.begin(), yard.player);
  ASSERT_GE(starts.size(), 12u);
  constexpr std::array kThrottles{Controls::kFull, -Controls::kFull};
  constexpr std::array kSteers{0, 30, -30};
  for (size_t s = 0; s < starts.size(); ++s) {
    for (size_t way = 0; way < runs(4); ++way) {
      Controls held;
      held.throttle = static_cast<int8_t>(kThrottles[way % 2]);
      held.steer = static_cast<int8_t>(kSteers[(way / 2 + s) % 3]);
      SCOPED_TRACE("start " + std::to_string(s) + ", throttle " + std::to_string(held.throttle) + ", steer " +
                   std::to_string(held.steer));
      const Standstill stood = longest_standstill(rules, starts[s], held, 20);
      EXPECT_LT(stood.unhelped, 3);
      EXPECT_LT(stood.all, 7) << "after two tries it is lifted";
    }
  }
}

TEST(Arena, of_the_yard_has_room_at_every_start_position) {
  const auto rules = yard_without_enemies();
  ASSERT_TRUE(rules);
  const FreeSpace space(rules->arena);
  for (const Start& start : rules->arena.description.enemies) {
    const FreeSpace::Spot spot = space.spot_at(start.position);
    EXPECT_GE(space.clearance(spot), 1.4) << start.position.x << ", " << start.position.z;
    for (const ModelBody& body : rules->arena.bodies) {
      if (body.body.pinned) continue;
      const double away = glm::length(Vec2(body.body.placement.position.x - start.position.x,
                                           body.body.placement.position.z - start.position.z));
      EXPECT_GT(away, 4) << body.body.own_name() << " at " << start.position.x << ", " << start.position.z;
    }
  }
}

}  // namespace
}  // namespace kerf
