#include "ui/editor/material/pointer_aim.h"

#include <algorithm>
#include <utility>

namespace kerf {

namespace {

constexpr double kEven = 0.2;   // s
constexpr double kResting = 5;  // pixels/s

}  // namespace

void PointerSpeed::follow(const Vec2& pointer, double seconds) {
  const std::optional<Vec2> before = std::exchange(last_, pointer);
  if (!before || seconds <= 0) return;
  const double now = glm::distance(*before, pointer) / seconds;
  speed_ += (now - speed_) * std::min(1.0, seconds / kEven);
}

std::optional<PointerAim> aim_of(const Workspace& on, const PointerSpeed& pointer) {
  const CameraView view = on.view.seen();
  const Vec2 p = on.view.in_picture(on.pointer);
  const std::optional<MetSheet> met = met_sheet(on.world(), on.view.look, view.ray(p.x, p.y));
  if (!met) return std::nullopt;
  const double half_height = view.parallel ? view.half_height() : met->length * view.tan_half_fov;
  const double pixel = 2 * half_height / on.view.pane().size.y;
  const double speed = pointer.pixels_per_second();
  return PointerAim{*met, speed > kResting ? speed * pixel : 0};
}

}  // namespace kerf
