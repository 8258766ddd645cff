#include "app/version.h"

#include <commit.h>

#include "core/base/version.h"

namespace kerf {

std::string version_text() {
  const std::string commit = KERF_COMMIT;
  return std::string("kerf ") + kVersion + (commit.empty() ? "" : " (" + commit + ")");
}

}  // namespace kerf
