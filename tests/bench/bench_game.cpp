#include <algorithm>
#include <memory>
#include <string>

#include "core/base/ids.h"
#include "core/game/match/match.h"
#include "tests/bench/sections.h"
#include "tests/bench/timing.h"
#include "tests/support/checkout.h"
#include "tests/support/piles.h"

namespace kerf::bench {

namespace {

constexpr double kMedianBar = 4, kSlowBar = 8.3;  // ms, of a tick: the median and the 99th percentile
constexpr size_t kEnemies = 5;

// The last wave of the standard rules as the only one: five enemies against the player.
std::shared_ptr<const Rules> last_wave() {
  const auto loaded = load_rules(test::checkout() / "assets" / "games" / "standard.json");
  if (!loaded) return nullptr;
  auto rules = std::make_shared<Rules>(**loaded);
  rules->waves = {rules->waves.back()};
  return rules;
}

bool all_alive(const Match& match) {
  const auto lives = [](const Vehicle& v) { return v.alive; };
  return match.vehicles().size() == 1 + kEnemies &&
         std::all_of(match.vehicles().begin(), match.vehicles().end(), lives);
}

// Adds a sheet to the loose things of an arena.
void add_sheet(Arena& arena, const Body& sheet) {
  ModelBody& model = arena.bodies.emplace_back();
  model.body = sheet;
  arena.description.bodies.emplace_back().cuttable = true;
}

// The arena strewn with sheets that sleep, and a quarter as many that are in the air and come down for
// seconds.
std::shared_ptr<const Rules> strewn(const Rules& rules, uint64_t sheets) {
  auto more = std::make_shared<Rules>(rules);
  constexpr double kHalfWidth = 30, kMaxFlight = 8;  // m, s
  World lying = test::rain(2 * sheets / 3, 1, kHalfWidth);
  Physics physics;
  for (Ticks t = 0; t == 0 || (physics.statistics().awake > 0 && t < 10 * kTicksPerSecond); ++t)
    physics.tick(lying);
  for (const BodyId id : lying.ids()) add_sheet(more->arena, lying.body(id));
  World flying = test::rain(sheets / 6, 2, kHalfWidth);
  const std::vector<BodyId> ids = flying.ids();
  for (size_t i = 0; i < ids.size(); ++i) {
    Body& sheet = flying.body(ids[i]);
    const double flight = kMaxFlight * static_cast<double>(i + 1) / static_cast<double>(ids.size());
    sheet.placement.position.y = 1;
    sheet.motion.velocity = -0.5 * flight * flying.environment().gravity;
    add_sheet(more->arena, sheet);
  }
  return more;
}

// What lies or flies about in a match besides its vehicles.
struct Loose {
  size_t all = 0, asleep = 0;
};

Loose loose_in(const Match& match) {
  Loose loose;
  for (const BodyId id : match.world().ids()) {
    const Body& body = match.world().body(id);
    if (body.pinned || match.vehicle_of(id) != Event::kNobody) continue;
    ++loose.all;
    loose.asleep += body.motion.asleep;
  }
  return loose;
}

// Ticks of fights of different seeds in which all vehicles were alive, and enough pieces lay about, but at
// most a quarter more.
struct Fight {
  std::vector<double> seconds;  // ascending
  size_t most_bodies = 0;
  Loose most;
};

Fight fight(const std::shared_ptr<const Rules>& rules, size_t ticks, const Loose& least) {
  constexpr uint64_t kMaxSeeds = 40;
  Fight result;
  for (uint64_t seed = 1; seed <= kMaxSeeds && result.seconds.size() < ticks; ++seed) {
    Match match({rules, seed, Difficulty::kNormal});
    BotPlayer bot(match);
    for (size_t t = 0; t < ticks && all_alive(match) && result.seconds.size() < ticks; ++t) {
      const Loose loose = loose_in(match);
      if (least.all > 0 && loose.all > 5 * least.all / 4) break;
      const double seconds = seconds_of([&] { match.tick(bot.next(match)); });
      if (loose.all < least.all || loose.asleep < least.asleep) continue;
      result.seconds.push_back(seconds);
      result.most_bodies = std::max(result.most_bodies, match.world().ids().size());
      result.most = {std::max(result.most.all, loose.all), std::max(result.most.asleep, loose.asleep)};
    }
  }
  std::sort(result.seconds.begin(), result.seconds.end());
  return result;
}

void report_fight(const std::string& name, const Fight& done, const Report& report) {
  if (done.seconds.empty()) return;
  const auto at = [&](double share) {
    const auto i = static_cast<size_t>(share * static_cast<double>(done.seconds.size()));
    return 1e3 * done.seconds[std::min(i, done.seconds.size() - 1)];
  };
  const auto count = [&](const char* what, size_t n) {
    report({what, name, "", static_cast<double>(n), 1, std::nullopt});
  };
  report({"median tick / limit", name, "ms", at(0.5), kMedianBar, 1.0});
  report({"99th percentile of ticks / limit", name, "ms", at(0.99), kSlowBar, 1.0});
  report({"longest tick / limit of the 99th percentile", name, "ms", at(1), kSlowBar, std::nullopt});
  count("ticks", done.seconds.size());
  count("bodies, max per tick", done.most_bodies);
  count("loose pieces, max per tick", done.most.all);
  count("of these asleep, max per tick", done.most.asleep);
}

}  // namespace

void bench_game(const Subject&, const Effort& effort, const Report& report) {
  const auto rules = last_wave();
  if (!rules) return;
  report_fight("1 against 5", fight(rules, effort.match_ticks, {}), report);
  const Loose least{effort.sheets, 3 * effort.sheets / 4};
  report_fight("and 200 pieces", fight(strewn(*rules, effort.sheets), effort.match_ticks, least), report);
}

}  // namespace kerf::bench
