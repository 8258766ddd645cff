#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/cut/cut_step.h"
#include "core/document/document.h"
#include "core/world/world.h"

namespace kerf::test {

// A stroke of two poses across the world: through a random point near its middle, along a random direction.
// With `tilt` the beam turns on the way.
struct RandomStroke {
  CutSettings settings;
  std::vector<BeamMove> moves;
};
RandomStroke random_stroke(const World& world, Random& random, double radius_share, bool tilt);

Vec3 random_direction(Random& random);

// Whole moves, in as many steps as they take: what those did together, or the first error.
Result<StepResult> cut_whole(World& world, const CutSettings& settings, std::span<const BeamMove> moves);
// The same of so many moves that wait in a document, and of all.
Result<StepResult> run_moves(Document& document, size_t moves);
Result<StepResult> run_all(Document& document);
// Runs all, and expects that nothing fails.
void finish(Document& document);

// A world of one body.
World world_of(const Soup& soup);
// A world of one body that a random stroke has cut, whose search for separated pieces is finished.
World cut_at_random(const Soup& soup, uint64_t seed);
Body& only_body(World& world);

}  // namespace kerf::test
