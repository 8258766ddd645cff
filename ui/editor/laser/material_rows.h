#pragma once

#include <optional>

#include "core/mesh/files/mesh_format.h"
#include "ui/editor/laser/stroke_watch.h"
#include "ui/editor/shared/workspace.h"
#include "ui/window/number_fields.h"

namespace kerf {

// The rows of the Laser panel that are about heat: the model, what the beam leaves or emits, whether heat is
// held, a forecast from the heat balance of a cut (see LumpedCut), and what the stroke does or the last one
// did.
class LaserHeatRows {
 public:
  // The forecast is for what the pointer is over, else for `sheet`.
  void draw(Workspace& workspace, const Sheet& sheet, const std::optional<PointerAim>& aim,
            const StrokeWatch& watch);

 private:
  void draw_geometric(LaserControls& laser, FileUnit unit);
  void draw_thermal(LaserControls& laser);
  void draw_forecast(const Workspace& workspace, const Sheet& sheet, const std::optional<PointerAim>& aim);
  void draw_strokes(const Workspace& workspace, const StrokeWatch& watch);

  NumberFields fields_;
};

// "2000 W cuts this sheet of 1 mm at up to 52 mm/s", and with a speed (m/s) what it cuts at that.
std::string forecast_text(const LaserControls& laser, const MetSheet& met, double speed, FileUnit unit);

// "The pointer goes at 80 mm/s, too fast to get through", or empty while it rests.
std::string pointer_text(const LaserControls& laser, const PointerAim& aim, FileUnit unit);

// "The beam does not get through, at 80 mm/s".
std::string beam_text(const StrokeWatch::Now& now, FileUnit unit);

// What would have got a stroke through that went too fast: "It would have got through at 20 mm/s instead of
// 80 mm/s, with 5.1 kW instead of 2 kW, or with a radius of 30 um instead of 100 um". Empty where it did, or
// where the heat balance says that it did.
std::string remedy_text(const StrokeWatch::Crossing& crossing, FileUnit unit);

// Where the energy of all beams went: "Emitted 1.2 kJ: 310 J absorbed, 220 J of it ejected".
std::string energy_text(const World& world);

// How deep the last stroke got where it was on a surface, or empty where it met none: "The last stroke got 40
// % of the way through".
std::string depth_text(const StepStatistics& statistics);

// Why a piece with this laser cannot be made solid: a sentence, or null.
const char* why_not_solid(bool closed, const LaserControls& laser);

// Whether a piece is closed. It is looked at again, in O(faces), once its faces have changed.
class KnownClosed {
 public:
  // Precondition: the world has the piece.
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

// The row of the Material panel that says whether a piece is solid.
class SolidRow {
 public:
  // Returns what the user has chosen, if anything.
  std::optional<bool> draw(const Workspace& workspace, const PieceId& piece);

 private:
  KnownClosed closed_;
};

}  // namespace kerf
