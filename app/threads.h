#pragma once

#include <optional>

#include "core/base/parallel.h"
#include "core/base/result.h"

namespace kerf {

// The limit that the environment variable KERF_THREADS sets, or none. Fails if it is not a whole number from
// 1 to 1024.
Result<std::optional<ThreadLimit>> threads_of_environment();

}  // namespace kerf
