#pragma once

#include "core/mesh/files/file_frame.h"
#include "ui/editor/shared/workspace.h"
#include "ui/window/number_fields.h"

namespace kerf {

// The rows of the Laser panel that are about heat: the model, what the beam leaves or emits, whether heat is
// held, a forecast from the heat balance of a cut (see LumpedCut), and what the last stroke did.
class LaserHeatRows {
 public:
  // `sheet` is the one that the forecast is for.
  void draw(Workspace& on, const Sheet& sheet);

 private:
  void draw_geometric(LaserControls& laser, FileUnit unit);
  void draw_thermal(LaserControls& laser);

  NumberFields fields_;
};

// "2000 W cuts this sheet of 1 mm at up to 52 mm/s", and with a speed what it cuts at that.
std::string forecast_text(const LaserControls& laser, const Sheet& sheet, double speed, FileUnit unit);

// Where the energy of all beams went: "Emitted 1.2 kJ: 310 J absorbed, 220 J of it ejected".
std::string energy_text(const World& world);

// How deep the last stroke got where it was on a surface, or empty where it met none: "The last stroke got 40
// % of the way through".
std::string depth_text(const StepStatistics& statistics);

}  // namespace kerf
