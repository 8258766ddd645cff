#pragma once

#include <string>

namespace kerf {

// Returns version and commit of the program, "kerf 0.1.0 (1234567890)"; only the version if it was built
// without git.
std::string version_text();

}  // namespace kerf
