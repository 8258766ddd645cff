#include "core/cut/stroke_region.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/random.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

// A stroke by hand: the beam goes on by little, from an apex or beside itself.
std::vector<BeamMove> wandering_moves(Random& random, bool from_apex) {
  const auto any = [&](double most) { return random.uniform(-most, most); };
  std::vector<BeamMove> moves;
  Pose pose{Vec3(any(1), 5, any(1)), glm::normalize(Vec3(any(0.2), -1, any(0.2)))};
  for (uint64_t i = 0, count = 1 + random.below(120); i < count; ++i) {
    Pose next = pose;
    if (from_apex) {
      next.direction = glm::normalize(pose.direction + Vec3(any(0.03), 0, any(0.03)));
    } else {
      next.origin += Vec3(any(0.1), 0, any(0.1));
    }
    moves.push_back({pose, next});
    pose = next;
  }
  return moves;
}

TEST(SweptDistance, is_the_minimum_over_all_parts) {
  for (uint64_t seed = 1; seed <= runs(200); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<BeamMove> moves = wandering_moves(random, seed % 2 == 0);
    StrokeRegion region;
    for (const BeamMove& m : moves) region.add(SweptCylinder(m.from, m.to, 0.05, {0.5, 9}));
    const SweptDistance distance(region, moves);
    for (int i = 0; i < 100; ++i) {
      const Pose& near = moves[random.below(moves.size())].from;
      const double spread = i % 2 == 0 ? 0.1 : 3;
      const auto any = [&] { return random.uniform(-spread, spread); };
      const Vec3 p = near.origin + random.uniform(0, 10) * near.direction + Vec3(any(), any(), any());
      double least = std::numeric_limits<double>::infinity();
      for (size_t k = 0; k < region.parts(); ++k) least = std::min(least, region.part(k).signed_distance(p));
      ASSERT_EQ(distance(p), least);
    }
  }
}

}  // namespace
}  // namespace kerf
