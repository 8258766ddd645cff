#pragma once

#include <string>

#include "core/mesh/build_mesh.h"

namespace kerf {

// One line on standard error.
void warn(const std::string& warning);

// What was odd in a mesh file and what was dropped from it, a line each on standard error.
void tell(const MeshReport& report);

}  // namespace kerf
