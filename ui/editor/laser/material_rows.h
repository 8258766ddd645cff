#pragma once

#include <optional>

#include "core/mesh/files/mesh_format.h"
#include "ui/editor/laser/stroke_watch.h"
#include "ui/editor/shared/workspace.h"
#include "ui/window/number_fields.h"

namespace kerf {

// Rows of the Laser panel on heat: the model, the heat that the beam leaves or emits, freezing of
// temperatures, a forecast from the heat balance (see LumpedCut), and the result of the current or last
// stroke.
class LaserHeatRows {
 public:
  // Forecasts for the sheet under the pointer, else for `sheet`.
  void draw(Workspace& workspace, const Sheet& sheet, const std::optional<PointerAim>& aim,
            const StrokeWatch& watch);

 private:
  void draw_geometric(LaserControls& laser, FileUnit unit);
  void draw_thermal(LaserControls& laser);
  void draw_forecast(const Workspace& workspace, const Sheet& sheet, const std::optional<PointerAim>& aim);
  void draw_strokes(const Workspace& workspace, const StrokeWatch& watch);

  NumberFields fields_;
};

// "2000 W cuts this sheet of 1 mm at up to 52 mm/s", or with a `speed` [m/s] > 0 the thickness cut at it.
std::string forecast_text(const LaserControls& laser, const SheetHit& met, double speed, FileUnit unit);

// "The pointer moves at 80 mm/s, too fast to cut through", or empty while it rests.
std::string pointer_text(const LaserControls& laser, const PointerAim& aim, FileUnit unit);

// "The beam does not cut through, at 80 mm/s".
std::string beam_text(const StrokeWatch::Now& now, FileUnit unit);

// Settings with which a failed stroke would have cut through: "It would have cut through at 20 mm/s instead
// of 80 mm/s, with 5.1 kW instead of 2 kW, or with a radius of 30 um instead of 100 um". Empty if it did,
// also by the heat balance.
std::string remedy_text(const StrokeWatch::Crossing& crossing, FileUnit unit);

// Energy balance of all beams: "Emitted 1.2 kJ: 310 J absorbed, 220 J of it ejected".
std::string energy_text(const World& world);

// Depth of the last stroke where it hit a surface, or empty if it hit none: "Last cut reached 40 % depth".
std::string depth_text(const StepStatistics& statistics);

// Returns why a piece cannot be made solid with this laser, as a sentence, or null if it can.
const char* solid_disabled_reason(bool closed, const LaserControls& laser);

// Caches whether a piece is closed. Recomputed, in O(faces), after its faces have changed.
class KnownClosed {
 public:
  // Precondition: the world contains the piece.
  bool of(const World& world, const PieceId& piece);

 private:
  struct Asked {
    PieceId piece;
    size_t faces;
    double area;
    friend bool operator==(const Asked&, const Asked&) = default;
  };
  std::optional<Asked> asked_;
  bool closed_ = false;
};

class SolidRow {
 public:
  // Returns the new value if the user has changed it.
  std::optional<bool> draw(const Workspace& workspace, const PieceId& piece);

 private:
  KnownClosed closed_;
};

}  // namespace kerf
