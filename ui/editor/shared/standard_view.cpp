#include "ui/editor/shared/standard_view.h"

#include <algorithm>

namespace kerf {

std::optional<StandardView> standard_view_of(const Camera& camera) {
  const auto* found =
      std::find_if(kStandardViews.begin(), kStandardViews.end(),
                   [&](const StandardView& view) { return camera.is_turned_to(view.yaw, view.pitch); });
  return found == kStandardViews.end() ? std::nullopt : std::optional(*found);
}

}  // namespace kerf
