#pragma once

#include "core/world/world.h"

namespace kerf::test {

// Expects two bodies to be the same to the bit: slots, corners, labels, the counts and areas of pieces, the
// boxes of the trees and where the beam was.
void expect_same_body(const Body& a, const Body& b);

// The same for all bodies of two worlds.
void expect_same_world(const World& a, const World& b);

}  // namespace kerf::test
