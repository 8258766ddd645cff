#include "ui/screen/shadow_statistics.h"

#include "core/base/assert.h"
#include "ui/window/number_text.h"

namespace kerf {

std::string tracing_text(const ShadowStatistics& statistics) {
  KERF_ASSERT(statistics.traced >= 0 && statistics.traced <= 1);
  return text_of("tracing %.0f %%", 100 * statistics.traced);
}

}  // namespace kerf
