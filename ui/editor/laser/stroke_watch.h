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

// How fast the pointer moves over the screen, evened out over a fifth of a second.
class PointerSpeed {
 public:
  // To be called once a frame; `seconds` have passed since the last call.
  void follow(const Vec2& pointer, double seconds);
  double pixels_per_second() const { return speed_; }

 private:
  std::optional<Vec2> last_;
  double speed_ = 0;
};

// What the pointer is over.
struct PointerAim {
  MetSheet met;
  double speed = 0;  // m/s, with which the pointer goes over it; 0 where it rests
};

// Nothing where the pointer is over no body. O(log faces).
std::optional<PointerAim> aim_of(const Workspace& workspace, const PointerSpeed& pointer);

// Watches the beam of a stroke of the thermal model: how fast it goes over what it meets, and whether it has
// got through, which shows behind it.
class StrokeWatch {
 public:
  // To be called once a frame, after the queue of the document was worked on, with the beam as it is drawn
  // (see LaserTool::picture): nothing if none is on.
  void follow(const Document& document, const std::optional<BeamPicture>& beam);

  // Of the stroke that is cut: whether the beam has got through what it met lately, and how fast it went
  // there (m/s, 0 as long as that is not known). Nothing while there is none or it meets nothing.
  struct Now {
    bool through = false;
    double speed = 0;
  };
  const std::optional<Now>& now() const { return now_; }

  // The last stroke that met something, and what it was at where it did not get through.
  struct Crossing {
    size_t step = 0;           // of the history
    size_t removed_faces = 0;  // by that step
    double share = 1;          // of the places on its way at which it got through
    double speed = 0;          // m/s, the mean where it did not
    MetSheet met;
    CutSettings settings;
  };
  // Nothing once that stroke is undone or cut otherwise.
  const Crossing* last(const Document& document) const;

 private:
  // A place on the way.
  struct Place {
    Pose axis;
    Vec3 strike;           // m, where the beam met something first
    double clock = 0;      // s, of the beam
    double speed = 0;      // m/s, since the place before
    double thickness = 0;  // m along the beam, in which what was met there lies
  };
  void begin(const Document& document);
  void pass(const Document& document, const BeamPicture& beam);
  double record_sheet(const World& world, const Pose& axis);
  static bool is_open(const World& world, const Place& place);
  void judge(const World& world, const Place& place);
  void rest(const World& world, const Place& place);
  void end(const Document& document);

  bool runs_ = false;
  std::deque<Place> way_;  // that is not judged yet, but for the place before
  size_t through_ = 0, not_through_ = 0;
  double too_fast_ = 0;  // m/s, summed up over `not_through_`
  Crossing crossing_;
  std::optional<Now> now_;
  std::optional<Crossing> last_;
};

}  // namespace kerf
