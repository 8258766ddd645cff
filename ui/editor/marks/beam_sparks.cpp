#include "ui/editor/marks/beam_sparks.h"

#include "ui/render/drawn_ground.h"

namespace kerf {

namespace {

constexpr double kCar = 4.5;  // m, the diagonal of what particles have their usual size for

}  // namespace

void BeamSparks::advance(double seconds, const LaserTool& beam, const Document& document, ViewState& view) {
  if (!view.look.sparks) particles_.clear();
  const UpAxis axis = view.camera.up_axis();
  const Vec3 up = axis == UpAxis::kZ ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  const World& world = document.world();
  const auto shown = view.look.sparks && !view.look.stage ? beam.picture(document) : std::nullopt;
  if (shown && shown->strike) {
    const Vec3 along = glm::normalize(shown->to - shown->from);
    particles_.add({*shown->strike, along, world.loaded_bounds().diagonal() / kCar, seconds}, up);
  }
  if (particles_.empty() && !view.look.effects) return;
  particles_.advance(seconds, up, height_of_drawn_ground(world, axis));
  auto effects = std::make_shared<Effects>();
  particles_.append_to(*effects);
  view.look.effects = particles_.empty() ? nullptr : std::move(effects);
  view.picture_old = true;
}

}  // namespace kerf
