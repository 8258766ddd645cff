#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/document/commands.h"
#include "core/world/world.h"

namespace kerf::test {

// A ring, which may be a solid, and leaves of a book above a ground, for tests of histories.
World ring_and_book(bool solid = false);

// A stroke across their middle with settings of its own. A beam that keeps its direction leaves a smooth rim,
// so that it can be closed by walls.
enum class Beam { kTurning, kStraight };
std::vector<Command> random_stroke_commands(Random& random, Beam beam = Beam::kTurning);

}  // namespace kerf::test
