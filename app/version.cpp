#include "app/version.h"

#include <commit.h>

namespace kerf {

std::string version_text() {
  const std::string commit = KERF_COMMIT;
  return "kerf " KERF_VERSION + (commit.empty() ? "" : " (" + commit + ")");
}

}  // namespace kerf
