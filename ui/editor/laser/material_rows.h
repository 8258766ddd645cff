#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/document/document.h"
#include "core/document/material_table.h"
#include "core/heat/lumped_cut.h"
#include "core/laser/laser.h"
#include "core/mesh/files/mesh_format.h"
#include "core/world/world.h"
#include "ui/editor/shared/workspace.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/render/view/view_options.h"
#include "ui/window/number_text.h"

namespace kerf {

// The first sheet that a ray hits.
struct SheetHit {
  Sheet sheet;
  double slant = 1;   // thickness along the ray relative to that of the sheet, at most 5
  double length = 0;  // distance from the origin of the ray [m]

  // Heat balance of a cut along the ray: at a slant the beam spreads over an ellipse, which removes more
  // metal. Conduction still uses the thickness of the sheet itself.
  LumpedCut balance(const Laser& laser) const {
    return {.substance = sheet.substance,
            .power = laser.power,
            .wavelength = laser.wavelength,
            .kerf = 2 * laser.radius * slant,
            .oxygen = laser.assist == Assist::kOxygen};
  }
};

// Intersects a ray with the visible faces (see pick); nullopt on a miss. Precondition: its direction is a
// unit vector.
std::optional<SheetHit> sheet_hit(const World& world, const ViewOptions& options, const Pose& ray);

// Speed of the pointer on the screen, smoothed over a fifth of a second.
class PointerSpeed {
 public:
  // Call once per frame, with the seconds since the last call.
  void follow(const Vec2& pointer, double seconds);
  double pixels_per_second() const { return speed_; }

 private:
  std::optional<Vec2> last_;
  double speed_ = 0;
};

struct PointerAim {
  SheetHit met;
  double speed = 0;  // of the pointer over the sheet [m/s], 0 at rest
};

// Returns nullopt if no body is under the pointer. O(log faces).
std::optional<PointerAim> aim_of(const Workspace& workspace, const PointerSpeed& pointer);

// Watches the beam of a thermal stroke: its speed over the surface, and whether it cuts through, judged
// behind the beam.
class StrokeWatch {
 public:
  // Call once per frame after processing the queue, with the beam as drawn (see LaserTool::picture), nullopt
  // if none is on.
  void follow(const Document& document, const std::optional<BeamPicture>& beam);

  // State of the current stroke; nullopt if there is none, or if it hits nothing.
  struct Now {
    bool through = false;  // the beam has recently cut through
    double speed = 0;      // there [m/s], 0 if unknown
  };
  const std::optional<Now>& now() const { return now_; }

  // Result of the last stroke that hit something.
  struct Crossing {
    size_t step = 0;           // history entry
    size_t removed_faces = 0;  // by that entry
    double share = 1;          // of the places on its path that were cut through
    double speed = 0;          // mean at the other places [m/s]
    SheetHit met;
    CutSettings settings;
  };
  // Returns null if that stroke was undone or recut.
  const Crossing* last(const Document& document) const;

 private:
  struct Place {
    Pose axis;
    Vec3 strike;           // first hit of the beam [m]
    double clock = 0;      // beam time [s]
    double speed = 0;      // since the previous place [m/s]
    double thickness = 0;  // extent of the hit sheet along the beam [m]
  };
  void begin(const Document& document, size_t step);
  void pass(const Document& document, const BeamPicture& beam);
  double record_sheet(const World& world, const Pose& axis);
  static bool is_open(const World& world, const Place& place);
  void judge(const World& world, const Place& place);
  void rest(const World& world, const Place& place);
  void end(const Document& document);

  bool runs_ = false;
  std::deque<Place> way_;  // the last judged place, then those not judged yet
  size_t through_ = 0, not_through_ = 0;
  double too_fast_ = 0;  // sum of the speeds [m/s] over `not_through_`
  Crossing crossing_;
  std::optional<Now> now_;
  std::optional<Crossing> last_;
};

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

// "2000 W cuts this sheet of 1 mm at up to 52 mm/s", or with a `speed` [m/s] > 0 the thickness cut at it. In
// a document that is not in metres, states that the thermal model takes its unit for one.
std::string forecast_text(const LaserControls& laser, const SheetHit& met, double speed, FileUnit unit);

// "The pointer moves at 80 mm/s, too fast to cut through", or empty while it rests.
std::string pointer_text(const LaserControls& laser, const PointerAim& aim, FileUnit unit);

// "The beam does not cut through, at 80 mm/s".
std::string beam_text(const StrokeWatch::Now& now, FileUnit unit);

// Settings with which a failed stroke would have cut through: "It would have cut through at 20 mm/s instead
// of 80 mm/s, with 5.1 kW instead of 2 kW, or with a radius of 30 um instead of 100 um". Empty if it did,
// also by the heat balance. States if the sheet does not absorb the beam.
std::string remedy_text(const StrokeWatch::Crossing& crossing, FileUnit unit);

// Energy balance of all beams: "Emitted 1.2 kJ: 310 J absorbed, 220 J of it ejected".
std::string energy_text(const World& world);

// Depth of the last stroke where it hit a surface, or empty if it hit none: "Last cut reached 40 % depth".
std::string depth_text(const StepStatistics& statistics);

// An edit of a sheet, of the members that were entered, even if the edited sheet already had these values.
struct SheetEdit {
  Sheet after;
  bool preset = false;  // a material was selected, which has all constants
  bool thickness = false;
  std::vector<double Substance::*> constants = {};

  // Returns `own` with the entered members.
  Sheet applied_to(Sheet own) const;
  bool sets_density() const;
};

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

// A change of the selected pieces, or of all if there are none.
struct MaterialChange {
  std::vector<PieceId> pieces;  // ascending
  std::optional<SheetEdit> sheet = {};
  std::optional<bool> solid = {};
  std::string cut_material = {};  // empty: unchanged
};

// Edits the sheet of the selected pieces, or of all pieces if none is selected: material (from
// assets/materials.json), thickness, constants, and solidity. Each change is one history entry and leaves the
// other properties of each piece unchanged.
class MaterialPanel {
 public:
  MaterialChange draw(const Workspace& workspace);

 private:
  const std::vector<PieceId>& pieces_of_fields(const Workspace& workspace);
  bool draw_presets(Sheet& sheet);
  void draw_numbers(SheetEdit& edit);

  NumberFields fields_;
  SolidRow solid_;
  std::vector<PieceId> edited_;                             // pieces whose sheets the fields edit
  std::optional<Result<std::vector<Material>>> materials_;  // set when the panel is first drawn
};

}  // namespace kerf
