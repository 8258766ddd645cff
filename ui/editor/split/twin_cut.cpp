#include "ui/editor/split/twin_cut.h"

#include "core/base/assert.h"

namespace kerf {

namespace {

// The world that the first's last stroke began with, or as it is where nothing was cut; none: too large.
std::optional<World> world_to_cut(Document& first) {
  if (first.history().last_cut()) return first.before_last_stroke();
  if (first.world().live_faces() > Document::kMostFacesToCopy) return std::nullopt;
  return first.world();
}

}  // namespace

void TwinCut::begin(Document& first, const Resolution& resolution) {
  std::optional<World> world = world_to_cut(first);
  there_ = world.has_value();
  document_ = there_ ? Document(std::move(*world)) : Document();
  document_.set_window(0);
  resolution_ = resolution;
  revision_ = first.revision();
  commands_ = 0;
  begun_ = true;
}

bool TwinCut::follow(Document& first, const ResolutionControls& controls) {
  if (!first.history().last_cut()) {
    const bool anew = !begun_ || first.revision() != revision_;
    if (anew) begin(first, controls.of(1));
    return anew;
  }
  const Resolution resolution = controls.of(first.history().last_settings().laser.radius);
  const bool anew = !begun_ || first.revision() != revision_ || resolution != resolution_;
  if (anew) begin(first, resolution);
  if (!there_) return anew;
  const std::vector<Command>& stroke = first.history().last_stroke();
  for (; commands_ < stroke.size(); ++commands_) {
    Command command = stroke[commands_];
    if (auto* start = std::get_if<BeginStroke>(&command)) {
      start->settings = first.history().last_settings();
      start->settings.resolution = resolution_;
    }
    // Time stands still in the twin.
    const bool in_time = std::visit([]<typename C>(const C&) { return HappensInTime<C>; }, command);
    if (in_time) continue;
    const Outcome applied = document_.apply(command);
    KERF_ASSERT(applied.ok());
    (void)applied;
  }
  return anew;
}

}  // namespace kerf
