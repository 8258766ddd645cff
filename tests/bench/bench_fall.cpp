#include <algorithm>

#include "core/base/tick.h"
#include "core/physics/physics.h"
#include "tests/bench/sections.h"
#include "tests/bench/timing.h"
#include "tests/support/made_meshes.h"
#include "tests/support/piles.h"

namespace kerf::bench {

namespace {

constexpr double kTickBar = 12;            // ms, the longest
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

void bench_rain(const Effort& effort, const Report& report) {
  World world = test::rain(effort.sheets, 1, 1.6);
  const size_t at_first = intersecting_pairs(world);
  Physics physics;
  std::vector<double> seconds;
  do {
    seconds.push_back(seconds_of([&] { physics.tick(world); }));
  } while (physics.figures().awake > 0 && seconds.size() < kLongest);
  const double longest = *std::max_element(seconds.begin(), seconds.end());
  const size_t new_ones = intersecting_pairs(world) - std::min(intersecting_pairs(world), at_first);
  const double share =
      100.0 * static_cast<double>(new_ones) / static_cast<double>(std::max<size_t>(touching_pairs(world), 1));
  report({"longest tick / limit", "rain", "ms", 1e3 * longest, kTickBar, 1.0});
  report({"median tick / limit of the longest", "rain", "ms", 1e3 * median(seconds), kTickBar, std::nullopt});
  report({"time until all sleep / limit", "rain", "s", seconds_of_ticks(seconds.size()), kSleepBar, 1.0});
  report({"interlocked of touching pairs / limit", "rain", "%", share, kInterlockedBar, 1.0});
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
  bench_rain(effort, report);
  bench_collider(22, kSmallColliderBar, effort, report);
  bench_collider(100, kLargeColliderBar, effort, report);
}

}  // namespace kerf::bench
