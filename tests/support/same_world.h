#pragma once

#include "core/world/world.h"

namespace kerf::test {

// Expects two worlds to be the same to the bit: bodies, slots, corners, labels, the counts and areas of
// pieces, the boxes of the trees and where the beam was.
void expect_same_world(const World& a, const World& b);

}  // namespace kerf::test
