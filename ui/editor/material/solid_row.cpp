#include "ui/editor/material/solid_row.h"

#include <imgui.h>

#include "core/mesh/enclosed_volume.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"

namespace kerf {

const char* why_not_solid(bool closed, const LaserControls& laser) {
  if (!closed) return "Only what is closed can be solid, and this piece has open edges.";
  if (laser.model == Model::kThermal)
    return "A thermal beam leaves no walls: choose the model Geometric in the Laser panel.";
  if (laser.pattern == Pattern::kRays4)
    return "Four rays leave no walls: choose the pattern Volume in the Laser panel.";
  if (laser.resolution.rim != Rim::kSmooth) return "Walls need a smooth rim: choose it in the Laser panel.";
  return nullptr;
}

bool KnownClosed::of(const World& world, const PieceId& piece) {
  const Body& body = world.body(piece.body);
  const Piece& counted = body.pieces[piece.label];
  const Asked now{piece, counted.faces, counted.area};
  if (asked_ == now) return closed_;
  asked_ = now;
  closed_ = enclosed_volume(body.mesh, body.faces_of(piece.label), body.middle()).closed;
  return closed_;
}

std::optional<bool> SolidRow::draw(const Workspace& on, const PieceId& piece) {
  bool solid = on.world().body(piece.body).solid;
  const char* why_not = nullptr;
  if (on.cutting()) {
    why_not = "Wait until the stroke is cut.";
  } else if (!solid) {
    why_not = why_not_solid(closed_.of(on.world(), piece), on.laser);
  }
  property("Solid");
  ImGui::BeginDisabled(why_not != nullptr);
  const bool changed = ImGui::Checkbox("##solid", &solid);
  ImGui::EndDisabled();
  mark_last_item("solid");
  tooltip(
      why_not != nullptr
          ? why_not
          : "The faces enclose a volume: strokes leave walls along the kerf, so that the pieces are closed "
            "again, and weigh what they hold. Otherwise they are a sheet.");
  return changed ? std::optional(solid) : std::nullopt;
}

}  // namespace kerf
