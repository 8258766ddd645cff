#pragma once

#include <vector>

#include "core/mesh/files/soup.h"

namespace kerf::test {

// The volumes of the connected parts of a closed mesh without what lies in a closed tool, cavities as
// negative ones: by CGAL's corefinement. Empty where it fails.
std::vector<double> volumes_of_difference(const Soup& part, const Soup& tool);

}  // namespace kerf::test
