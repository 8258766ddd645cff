#pragma once

#include "core/mesh/files/soup.h"
#include "core/world/world.h"

namespace kerf::test {

// Sheets for rigid bodies, in m.
Soup rectangle(double width, double depth, int cells);  // in y = 0, around the origin
Soup disc(double radius, int sectors);                  // in y = 0, around the origin
// A square in y = 0 with a round hole in its middle.
Soup plate_with_hole(double size, double hole_radius, int sectors);
Soup closed_box(const Vec3& size);                    // around the origin
Soup rod(double radius, double length, int sectors);  // along y, closed by discs

// Adds a body of a soup at a place.
BodyId add(World& world, const Soup& soup, const Vec3& position,
           const glm::dquat& orientation = {1, 0, 0, 0});

}  // namespace kerf::test
