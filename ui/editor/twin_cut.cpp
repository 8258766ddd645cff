#include "ui/editor/twin_cut.h"

namespace kerf {

namespace {

// The world that the first's last stroke began with, or as it is where nothing was cut; null: too large.
const World* world_to_cut(const Document& first) {
  if (first.strokes() > 0) return first.before_last_stroke();
  return first.world().live_faces() <= Document::kMostFacesToRecut ? &first.world() : nullptr;
}

}  // namespace

void TwinCut::begin(const Document& first, const Resolution& resolution) {
  const World* world = world_to_cut(first);
  there_ = world != nullptr;
  document_ = there_ ? Document(*world) : Document();
  resolution_ = resolution;
  stroke_ = first.strokes();
  commands_ = 0;
  begun_ = true;
}

bool TwinCut::follow(const Document& first, const ResolutionControls& controls) {
  const double radius = first.stroke_settings().laser.radius;
  const Resolution resolution = controls.of(radius);
  const bool anew =
      !begun_ || first.strokes() != stroke_ || (resolution != resolution_ && first.strokes() > 0);
  if (anew) begin(first, resolution);
  if (!there_ || first.strokes() == 0) return anew;
  const std::span<const Command> stroke = first.last_stroke();
  for (; commands_ < stroke.size(); ++commands_) {
    Command command = stroke[commands_];
    if (auto* start = std::get_if<BeginStroke>(&command)) start->settings.resolution = resolution_;
    document_.apply(command);
  }
  return anew;
}

}  // namespace kerf
