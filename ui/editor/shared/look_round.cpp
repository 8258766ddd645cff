#include "ui/editor/shared/look_round.h"

#include <cmath>

namespace kerf {

namespace {

constexpr double kOrbitPerHeight = 3.6;  // radians for a drag over the height of the picture
constexpr double kZoomPerNotch = 0.88;

// How far the pointer has moved since the last call, in heights of the picture.
Vec2 way_of(const Workspace& on, Vec2& last) {
  return (on.pointer - std::exchange(last, on.pointer)) / on.view.pane().size.y;
}

}  // namespace

void Orbit::move(const InputEvent&) {
  const Vec2 way = way_of(on_, last_);
  const double speed = on_.settings.drag_speed;
  on_.view.camera.orbit(-way.x * kOrbitPerHeight * speed, way.y * kOrbitPerHeight * speed);
}

void Pan::move(const InputEvent&) {
  const Vec2 way = 2.0 * way_of(on_, last_);
  on_.view.camera.pan(way.x / on_.view.aspect(), -way.y, on_.view.aspect());
}

void zoom(Workspace& on, double notches) {
  const Vec2 p = on.view.in_picture(on.pointer);
  on.view.camera.zoom(std::pow(kZoomPerNotch, notches * on.settings.wheel_speed), p.x, p.y, on.view.aspect());
}

}  // namespace kerf
