#pragma once

#include <deque>
#include <optional>

#include "core/base/geometry.h"
#include "core/document/document.h"
#include "core/heat/lumped_cut.h"
#include "core/laser/laser.h"
#include "core/world/world.h"
#include "ui/editor/shared/workspace.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/render/view/view_options.h"

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
  void begin(const Document& document);
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

}  // namespace kerf
