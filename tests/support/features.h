#pragma once

#include <array>
#include <set>
#include <utility>

#include "core/mesh/files/soup.h"
#include "core/mesh/mesh.h"

namespace kerf::test {

using Place = std::array<double, 3>;
Place place(const Vec3& p);

// The edges by position that are no inner edges of one material: on boundaries, in rings, between materials.
std::set<std::pair<Place, Place>> feature_edges(const Mesh& mesh);

// The soup with two materials, "red" and "blue", of which the second has the triangles that begin at x >
// 0.05.
Soup in_two_materials(Soup soup);

}  // namespace kerf::test
