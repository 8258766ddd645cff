#include <cmath>
#include <cstdio>
#include <string>

#include "core/document/material_table.h"
#include "core/heat/lumped_cut.h"
#include "tests/bench/published_cuts.h"
#include "tests/bench/sections.h"
#include "tests/support/checkout.h"
#include "tests/support/laser_strips.h"

namespace kerf::bench {

namespace {

constexpr double kSlowest = 1.0 / 3;  // of the published speed, at which a strip is tried

Row row_of(const PublishedCut& cut, const char* kind, double speed, double published) {
  char name[128];
  std::snprintf(name, sizeof name, "%s %d: %g mm, %g W", kind, cut.number, cut.millimetres, cut.watts);
  return {name, cut.what, "m/min", 60 * speed, 60 * published, std::nullopt};
}

}  // namespace

// Beside the published speed: that of the lumped balance, and that of the simulation, the highest at which a
// strip falls in two.
void bench_laser(const Subject&, const Effort& effort, const Report& report) {
  const auto materials = load_materials(test::checkout() / "assets" / "materials.json");
  if (!materials) return (void)std::printf("%s\n", materials.error().message.c_str());
  for (const PublishedCut& cut : published_cuts().first(effort.published_cuts)) {
    const Substance substance = find_material(*materials, cut.material)->substance;
    const test::LaserStrip strip{substance, 1e-3 * cut.millimetres, cut.watts, 1e-3 * cut.kerf, 1,
                                 cut.assist};
    const double published = 0.5 * (cut.slowest + cut.fastest) / 60;
    const LumpedCut lumped{.substance = substance,
                           .power = cut.watts,
                           .kerf = strip.kerf,
                           .oxygen = cut.assist == Assist::kOxygen};
    report(row_of(cut, "lumped", cutting_speed(lumped, strip.thickness), published));
    const double simulated = test::fastest_cut(strip, kSlowest * published, published);
    report(row_of(cut, "simulated", simulated, published));
    if (cut.why[0] != 0) std::printf("  %s\n", cut.why);
  }
}

}  // namespace kerf::bench
