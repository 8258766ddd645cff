#pragma once

#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/world/world.h"

namespace kerf {

// Loads a mesh file with load_mesh and makes a body of it with make_body. Fails like these; `progress` may be
// null.
Result<Body> load_body(std::string name, const std::filesystem::path& file, const Progress* progress);

}  // namespace kerf
