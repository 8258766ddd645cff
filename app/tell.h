#pragma once

#include <string>

#include "core/base/result.h"
#include "core/mesh/build_mesh.h"

namespace kerf {

// Flushes standard output. Fails if it cannot be written.
Status flush_output();

// Prints a warning as one line on standard error.
void warn(const std::string& warning);

// Prints the notes about a mesh file, i.e. what was dropped and what is unusual, one line each on standard
// error.
void tell(const MeshReport& report);

}  // namespace kerf
