#pragma once

#include <string>

namespace kerf {

// "kerf 0.1.0 (1234567890)": the version and the commit from which the program was built, or the version
// alone where it was built without git.
std::string version_text();

}  // namespace kerf
