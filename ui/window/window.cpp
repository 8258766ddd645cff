#include "ui/window/window.h"

namespace kerf {

Area pixels_of(const Area& area, const Window& window) {
  const Vec2 scale = window.pixel_size() / window.size();
  const Vec2 from = glm::floor(area.at * scale), to = glm::floor((area.at + area.size) * scale);
  return {from, glm::max(Vec2(1), to - from)};
}

}  // namespace kerf
