#include <gtest/gtest.h>

#include <cstdio>
#include <map>

#include "tests/support/runs.h"
#include "tests/support/solids.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

struct Tally {
  size_t closed = 0, open = 0, specks = 0;
};

// One to three strokes through each solid, as long as it stays closed.
TEST(SolidStrokes, keep_solids_closed_or_report_open_ones) {
  const std::vector<NamedSoup> solids = generated_solids();
  const size_t most = runs(500);
  std::map<std::string, Tally> kinds;
  Tally all;
  for (uint64_t seed = 1; all.closed + all.open < most; ++seed) {
    Random random(seed);
    const auto& [name, soup] = solids[seed % solids.size()];
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    SolidCut cut(world_of(soup));
    bool closed = true;
    for (uint64_t left = 1 + random.below(3); left > 0 && closed; --left) {
      const SolidStroke stroke = random_solid_stroke(cut.document().world(), random);
      SCOPED_TRACE(stroke.name);
      closed = cut.draw(stroke, random);
      for (Tally* tally : {&all, &kinds[stroke.name]}) ++(closed ? tally->closed : tally->open);
      all.specks += cut.specks();
      if (closed) continue;
      ASSERT_FALSE(cut.reasons().empty());
      std::printf("left open: %s, seed %zu, %s: %s\n", name.c_str(), static_cast<size_t>(seed),
                  stroke.name.c_str(), cut.reasons().back().c_str());
    }
  }
  std::printf("%zu strokes, of which %zu left a solid open; %zu specks\n", all.closed + all.open, all.open,
              all.specks);
  for (const auto& [name, tally] : kinds)
    std::printf("  %-12s %4zu closed %4zu open\n", name.c_str(), tally.closed, tally.open);
  EXPECT_LE(all.open, 1 + most / 250);
  EXPECT_LE(all.specks, 1 + most / 100);
}

}  // namespace
}  // namespace kerf::test
