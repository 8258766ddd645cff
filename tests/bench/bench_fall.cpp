#include <algorithm>
#include <filesystem>

#include "core/base/ids.h"
#include "core/physics/physics.h"
#include "tests/bench/sections.h"
#include "tests/bench/timing.h"
#include "tests/support/checkout.h"
#include "tests/support/made_meshes.h"
#include "tests/support/piles.h"

namespace kerf::bench {

namespace {

constexpr double kRainTickBar = 12;        // ms, the longest
constexpr double kCollapseTickBar = 25;    // ms, the longest
constexpr double kRestTickBar = 0.2;       // ms, while all sleep
constexpr double kSleepBar = 5;            // s until all sleep
constexpr double kInterlockedBar = 5;      // percent of the pairs that touch
constexpr double kSmallColliderBar = 0.5;  // ms, of 1,000 faces with its tree
constexpr double kLargeColliderBar = 9;    // ms, of 20,000
constexpr Ticks kLongest = 10 * kTicksPerSecond;

size_t touching_pairs(const World& world) {
  const ContactMemory& memory = world.contact_memory();
  return static_cast<size_t>(std::count_if(
      memory.begin(), memory.end(), [](const PairMemory& m) { return m.touching && m.second.valid(); }));
}

size_t intersecting_pairs(const World& world) {
  size_t count = 0;
  const std::vector<BodyId> ids = world.ids();
  for (size_t i = 0; i < ids.size(); ++i) {
    for (size_t j = i + 1; j < ids.size(); ++j)
      count += test::intersect(world.body(ids[i]), world.body(ids[j])) ? 1 : 0;
  }
  return count;
}

// Each of the ticks until all sleep, at most kLongest.
struct Ticked {
  std::vector<double> seconds;
  TickStatistics most;  // of any tick
  bool asleep = false;
};

Ticked tick_until_rest(World& world, Physics& physics) {
  Ticked ticked;
  while (!ticked.asleep && ticked.seconds.size() < kLongest) {
    ticked.seconds.push_back(seconds_of([&] { physics.tick(world); }));
    const TickStatistics& statistics = physics.statistics();
    ticked.most.candidates = std::max(ticked.most.candidates, statistics.candidates);
    ticked.most.contacts = std::max(ticked.most.contacts, statistics.contacts);
    ticked.asleep = statistics.awake == 0;
  }
  return ticked;
}

double share_interlocked(const World& world, size_t at_first) {
  const size_t now = intersecting_pairs(world), touching = touching_pairs(world);
  return 100.0 * static_cast<double>(now - std::min(now, at_first)) /
         static_cast<double>(std::max<size_t>(touching, 1));
}

void bench_pile(const std::string& name, double tick_bar, World world, const Report& report) {
  const size_t at_first = intersecting_pairs(world);
  Physics physics;
  // What is made once, the colliders, is a row of its own.
  {
    World first_tick = world;
    physics.tick(first_tick);
  }
  const Ticked ticked = tick_until_rest(world, physics);
  const double longest = *std::max_element(ticked.seconds.begin(), ticked.seconds.end());
  report({"longest tick / limit", name, "ms", 1e3 * longest, tick_bar, 1.0});
  report({"median tick / limit of the longest", name, "ms", 1e3 * median(ticked.seconds), tick_bar,
          std::nullopt});
  report({"pairs near each other, max per tick", name, "", static_cast<double>(ticked.most.candidates), 1,
          std::nullopt});
  report({"contacts, max per tick", name, "", static_cast<double>(ticked.most.contacts), 1, std::nullopt});
  report({"interlocked of touching pairs / limit", name, "%", share_interlocked(world, at_first),
          kInterlockedBar, 1.0});
  report({"time until all sleep / limit", name, "s", seconds_of_ticks(ticked.seconds.size()), kSleepBar,
          name == "rain" ? std::optional(1.0) : std::nullopt});
  if (!ticked.asleep) return;
  const double at_rest = seconds_of([&] { physics.tick(world); });
  report({"tick while all sleep / limit", name, "ms", 1e3 * at_rest, kRestTickBar, 1.0});
}

void bench_collider(int cells, double bar, const Effort& effort, const Report& report) {
  const Mesh mesh = test::build(test::grid(cells, 1)).mesh;
  std::vector<double> seconds;
  for (int i = 0; i < effort.build_times; ++i) {
    seconds.push_back(seconds_of([&] {
      const AabbTree tree(mesh);
      make_collider(mesh);
    }));
  }
  report({"collider with its tree / limit", std::to_string(mesh.live_faces()) + " faces", "ms",
          1e3 * median(seconds), bar, 1.0});
}

}  // namespace

void bench_fall(const Subject&, const Effort& effort, const Report& report) {
  bench_pile("rain", kRainTickBar, test::rain(effort.sheets, 1, 1.6), report);
  const std::filesystem::path car = test::checkout() / "assets" / "meshes" / "car.obj";
  bench_pile("car", kCollapseTickBar, test::cut_to_pieces(car.c_str(), effort.cuts, 1, 10), report);
  bench_collider(22, kSmallColliderBar, effort, report);
  bench_collider(100, kLargeColliderBar, effort, report);
}

}  // namespace kerf::bench
