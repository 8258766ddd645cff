#include "ui/editor/path/fire_pace.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

void FirePace::set(double per_second) { per_second_ = std::clamp(per_second, kSlowest, kFastest); }

bool FirePace::is_due(double now) const { return !last_ || (now - *last_) * per_second_ >= 1; }

void FirePace::take(double now) {
  KERF_ASSERT(is_due(now));
  last_ = last_ ? *last_ + std::floor((now - *last_) * per_second_) / per_second_ : now;
}

}  // namespace kerf
