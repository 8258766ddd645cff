#include "ui/screen/shadow_figures.h"

#include "ui/window/number_text.h"

namespace kerf {

std::string tracing_text(const ShadowFigures& figures) {
  return text_of("tracing %.0f %%", 100 * figures.traced);
}

}  // namespace kerf
