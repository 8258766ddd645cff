#include "ui/window/input_event.h"

#include "core/base/assert.h"

namespace kerf {

void spread_times(std::span<InputEvent> events, double from, double to) {
  KERF_ASSERT(from <= to);
  const auto count = static_cast<double>(events.size());
  for (size_t i = 0; i < events.size(); ++i)
    events[i].seconds = from + (to - from) * (static_cast<double>(i + 1) / count);
}

}  // namespace kerf
