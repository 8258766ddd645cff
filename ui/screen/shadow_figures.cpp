#include "ui/screen/shadow_figures.h"

#include "core/base/assert.h"
#include "ui/window/number_text.h"

namespace kerf {

std::string tracing_text(const ShadowFigures& figures) {
  KERF_ASSERT(figures.traced >= 0 && figures.traced <= 1);
  return text_of("tracing %.0f %%", 100 * figures.traced);
}

}  // namespace kerf
