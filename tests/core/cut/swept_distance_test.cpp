#include "core/cut/stroke_region.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

// A stroke by hand in small moves: the beam turns about an apex or shifts sideways, and advances or retreats
// by up to `along` metres along itself.
std::vector<BeamMove> wandering_moves(Random& random, bool from_apex, double along = 0) {
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
    if (along > 0) next.origin += any(along) * pose.direction;
    moves.push_back({pose, next});
    pose = next;
  }
  return moves;
}

// A beam that turns about an axis, a part of a turn or more than one, and may advance along it.
std::vector<BeamMove> turning_moves(Random& random) {
  const Vec3 axis = glm::normalize(Vec3(random.uniform(-1, 1), 2, random.uniform(-1, 1)));
  const Vec3 right = glm::normalize(glm::cross(axis, Vec3(1, 0, 0))), up = glm::cross(axis, right);
  const double away = random.uniform(4, 8), offset = random.uniform(-2, 2), slope = random.uniform(-0.2, 0.2);
  const uint64_t count = 1 + random.below(400);
  const double turn = random.uniform(0.5, 7) / static_cast<double>(count);
  const auto pose = [&](uint64_t i) {
    const double angle = turn * static_cast<double>(i);
    const auto [sin, cos] = sin_cos(angle);
    const Vec3 out = cos * right + sin * up, aside = cos * up - sin * right;
    return Pose{away * out + offset * aside + slope * angle * axis, -out};
  };
  std::vector<BeamMove> moves;
  for (uint64_t i = 0; i < count; ++i) moves.push_back({pose(i), pose(i + 1)});
  return moves;
}

TEST(SweptDistance, is_the_minimum_over_all_parts) {
  for (uint64_t seed = 1; seed <= runs(300); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<BeamMove> moves = seed % 4 == 2   ? turning_moves(random)
                                        : seed % 4 == 3 ? wandering_moves(random, false, 1)
                                                        : wandering_moves(random, seed % 4 == 0);
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
