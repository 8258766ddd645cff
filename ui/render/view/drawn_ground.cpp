#include "ui/render/view/drawn_ground.h"

namespace kerf {

namespace {
constexpr double kGapToGround =
    5e-4;  // between the bodies and the ground, in diagonals: what lies flat shows
constexpr double kEarthGravity = 9.81;  // m/s^2
}  // namespace

double height_of_drawn_ground(const World& world, UpAxis up) {
  const Environment& around = world.environment();
  if (around.ground && around.up() == from_y_up({0, 1, 0}, up)) return *around.ground;
  const World::Bounds bounds = world.loaded_bounds();
  const double diagonal = bounds.diagonal() > 0 ? bounds.diagonal() : 1;
  return height_of(bounds.min, up) - kGapToGround * diagonal;
}

Environment default_environment(const World& world, const FileFrame& frame) {
  const Vec3 down = from_y_up({0, -1, 0}, frame.up);
  const double metre = 1 / metres_per_unit(frame.unit);
  return {kEarthGravity * metre * down, height_of_drawn_ground(world, frame.up), metre};
}

Environment fitting_environment(const World& world, const FileFrame& frame) {
  Environment around = world.environment();
  if (around.gravity == Vec3(0)) return around;
  if (!around.ground) return default_environment(world, frame);
  const double metre = 1 / metres_per_unit(frame.unit);
  if (around.metre == metre) return around;
  around.gravity *= metre / around.metre;
  around.metre = metre;
  return around;
}

}  // namespace kerf
