#pragma once

#include <optional>

#include "core/heat/lumped_cut.h"
#include "core/laser/laser.h"
#include "core/world/world.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The sheet that a ray meets first.
struct MetSheet {
  Sheet sheet;
  double slant = 1;   // how many times as thick it is along the ray, at most 5
  double length = 0;  // m, from the origin of the ray

  // The heat balance of a cut through it by a beam along the ray: at a slant the beam is spread over an
  // ellipse, which takes more metal with it. Heat is still conducted into a sheet of its own thickness.
  LumpedCut balance(const Laser& laser) const {
    return {.substance = sheet.substance,
            .power = laser.power,
            .wavelength = laser.wavelength,
            .kerf = 2 * laser.radius * slant,
            .oxygen = laser.assist == Assist::kOxygen};
  }
};

// As seen with these options (see pick); nothing where the ray meets nothing. Precondition: its direction is
// a unit vector.
std::optional<MetSheet> met_sheet(const World& world, const ViewOptions& options, const Pose& ray);

}  // namespace kerf
