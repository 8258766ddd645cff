#include "ui/editor/laser/beam_sparks.h"

#include <utility>

#include "ui/render/view/drawn_ground.h"

namespace kerf {

namespace {

constexpr double kCar = 4.5;  // m, the diagonal of what particles have their usual size for

}  // namespace

void BeamSparks::advance(double seconds, const LaserTool& beam, const Document& document,
                         const WaitingStrokes& waiting, bool waiting_changed, ViewState& view) {
  if (!view.look.sparks) particles_.clear();
  const UpAxis axis = view.camera.up_axis();
  const Vec3 up = axis == UpAxis::kZ ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  const World& world = document.world();
  const double before = std::exchange(removed_, document.history().removed_mass());
  const double mass = removed_ - before;
  const bool wanted = mass > 0 && view.look.sparks && !view.look.stage;
  const auto shown = wanted ? beam.picture(document) : std::nullopt;
  if (shown && shown->strike) {
    const Vec3 along = glm::normalize(shown->to - shown->from);
    particles_.add({*shown->strike, along, world.loaded_bounds().diagonal() / kCar, mass}, up);
  }
  if (particles_.empty() && !had_particles_ && !waiting_changed) return;
  particles_.advance(seconds, up, height_of_drawn_ground(world, axis));
  auto effects = std::make_shared<Effects>();
  particles_.append_to(*effects);
  for (const WaitingStrokes::Stroke& stroke : waiting.strokes()) effects->beams.push_back(stroke.beam);
  had_particles_ = !particles_.empty();
  view.look.effects = had_particles_ || !effects->beams.empty() ? std::move(effects) : nullptr;
  view.picture_old = true;
}

}  // namespace kerf
