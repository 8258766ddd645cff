#pragma once

#include <string>

#include "core/mesh/build_mesh.h"

namespace kerf {

// Prints a warning as one line on standard error.
void warn(const std::string& warning);

// Prints the notes about a mesh file, i.e. what was dropped and what is unusual, one line each on standard
// error.
void tell(const MeshReport& report);

}  // namespace kerf
