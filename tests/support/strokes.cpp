#include "tests/support/strokes.h"

#include <gtest/gtest.h>

#include "core/document/document.h"
#include "core/edit/separation.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {

Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double length2 = glm::dot(v, v);
    if (length2 > 0.01 && length2 < 1) return glm::normalize(v);
  }
}

RandomStroke random_stroke(const World& world, Random& random, double radius_share, bool tilt) {
  const World::Bounds bounds = world.bounds();
  const double size = bounds.diagonal();
  const Vec3 axis = random_direction(random);
  const Vec3 along = glm::normalize(glm::cross(axis, random_direction(random)));
  const Vec3 middle = 0.5 * (bounds.min + bounds.max) + 0.1 * size * random_direction(random);
  const double half = random.uniform(0.2, 0.7) * size;
  const Vec3 end_axis = tilt ? glm::normalize(axis + 0.3 * random_direction(random)) : axis;
  RandomStroke stroke;
  stroke.settings.laser.radius = radius_share * size;
  stroke.settings.laser.range = {0, 3 * size};
  stroke.settings.resolution.target_edge = radius_share * size * random.uniform(0.6, 1.5);
  if (random.below(2) == 0) stroke.settings.resolution.scheme = Scheme::kOneToFour;
  stroke.moves = subdivide(
      {{middle - size * axis - half * along, axis}, {middle - size * end_axis + half * along, end_axis}},
      stroke.settings.laser.radius, 2 * size);
  return stroke;
}

namespace {

void add(StepResult& all, StepResult some) {
  all.moves += some.moves;
  all.delta.append(std::move(some.delta));
  all.statistics.add(some.statistics);
}

}  // namespace

Result<StepResult> cut_whole(World& world, const CutSettings& settings, std::span<const BeamMove> moves) {
  StepResult all;
  UnfinishedMove unfinished;
  while (all.moves < moves.size()) {
    Result<StepResult> some = cut_step(world, settings, moves.subspan(all.moves), unfinished);
    if (!some) return some;
    add(all, std::move(*some));
  }
  return all;
}

Result<StepResult> run_moves(Document& document, size_t moves) {
  StepResult all;
  QueueRun how;
  how.moves_a_step = moves;
  how.leave = document.waiting() - moves;
  how.told = [&](const Result<StepResult>& some) -> Status {
    if (!some) return some.error();
    add(all, *some);
    return Done{};
  };
  if (const Status ran = run_queue(document, how); !ran) return ran.error();
  return all;
}

Result<StepResult> run_all(Document& document) { return run_moves(document, document.waiting()); }

void finish(Document& document) { ASSERT_TRUE(run_all(document).ok()); }

World world_of(const Soup& soup) {
  World world;
  world.add(make_body("body", build(soup)));
  return world;
}

World cut_at_random(const Soup& soup, uint64_t seed) {
  World world = world_of(soup);
  Random random(seed);
  const RandomStroke stroke = random_stroke(world, random, 0.05, true);
  EXPECT_TRUE(cut_whole(world, stroke.settings, stroke.moves).ok());
  while (!is_settled(world)) continue_separation(world, 100'000);
  return world;
}

Body& only_body(World& world) { return world.body(world.ids()[0]); }

}  // namespace kerf::test
