#pragma once

#include "core/world/world.h"

namespace kerf::test {

// Expects two bodies to be the same to the bit: slots, corners, labels, the counts and areas of pieces, the
// boxes of the trees and where the beam was.
void expect_same_body(const Body& a, const Body& b);

// The same for all bodies of two worlds, and their ids.
void expect_same_world(const World& a, const World& b);

// The same but for the ids and numbers of the bodies, which need only come in the same order: for worlds that
// different journals led to.
void expect_same_bodies(const World& a, const World& b);

}  // namespace kerf::test
