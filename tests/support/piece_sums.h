#pragma once

#include "core/world/world.h"

namespace kerf::test {

// Sums up faces, area and moments of every piece over the live faces of a settled body, and expects the sums
// that the body keeps: the same number of faces, areas within 1e-9 of the area as loaded, and moments within
// 1e-9 of that area times the first or second power of half the diagonal of the mesh as loaded.
void expect_piece_sums(const Body& body);

// Likewise, also for the faces and areas of the connected parts. Returns the number of parts.
size_t expect_part_counts(const Body& body);

}  // namespace kerf::test
