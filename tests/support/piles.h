#pragma once

#include "core/world/world.h"

namespace kerf::test {

// A world with gravity along -Y and the ground at y = 0.
World world_with_ground();

// Lets the bodies move for so many seconds.
void let_move(World& world, double seconds);

// So many random sheets (plates, discs, tubes and plates with a hole, all of a few hundred faces) above each
// other over a square of this half width (m), turned at random.
World rain(uint64_t count, uint64_t seed, double half_width);

// The mesh of a file, standing as loaded, cut by so many vertical planes across each horizontal axis and so
// many horizontal ones, at random places. Each piece of at least `least_faces` faces is a body of its own;
// the others are removed. Empty if the file cannot be read.
World cut_to_pieces(const char* file, int planes, uint64_t seed, size_t least_faces);

// Whether a triangle of one body meets a triangle of the other: whether an edge of one crosses a face of the
// other.
bool intersect(const Body& a, const Body& b);

}  // namespace kerf::test
