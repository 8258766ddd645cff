#include <gtest/gtest.h>

#include "core/game/match/match.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

// What comes of driving against the edge of the arena from `away` metres, with the throttle held.
struct Drive {
  double fastest = 0;  // m/s
  double hardest = 0;  // m/s, the largest impact
  size_t pieces = 0;   // that came off
  bool alive = true;
  uint64_t hash = 0;
};

Drive drive_against_the_edge(double away) {
  WaveStart start;
  start.player.position = {0, 0, 98 - away};
  Match match({test::flat_rules(0, 0), 1, Difficulty::kNormal}, start);
  Controls controls;
  controls.throttle = Controls::kFull;
  Drive drive;
  for (Ticks t = 0; t < 6 * kTicksPerSecond; ++t) {
    match.tick(controls);
    const Vehicle& own = match.vehicles()[Match::kPlayer];
    drive.fastest = std::max(drive.fastest, match.world().body(own.chassis).motion.velocity.z);
    for (const Event& e : match.events()) {
      if (e.kind == Event::Kind::kImpact) drive.hardest = std::max(drive.hardest, e.size);
      drive.pieces += e.kind == Event::Kind::kPieceOff;
    }
    drive.alive = own.alive;
  }
  drive.hash = state_hash(match.world());
  return drive;
}

TEST(Match, only_a_crash_at_speed_breaks_parts_off) {
  const Drive slow = drive_against_the_edge(5), fast = drive_against_the_edge(40);
  EXPECT_LT(slow.hardest, kCrash);
  EXPECT_GT(slow.fastest, 2);
  EXPECT_EQ(slow.pieces, 0u);
  EXPECT_GT(fast.hardest, kCrash);
  EXPECT_GT(fast.pieces, 1u);
  EXPECT_TRUE(fast.alive) << "what keeps a car going stays on it";
  EXPECT_EQ(drive_against_the_edge(40).hash, fast.hash);
}

}  // namespace
}  // namespace kerf
