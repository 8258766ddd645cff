#pragma once

#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/world/world.h"

namespace kerf {

// A body of the mesh in a file (load_mesh, then make_body), or why there is none. `progress` may be null.
Result<Body> load_body(std::string name, const std::filesystem::path& file, const Progress* progress);

}  // namespace kerf
