#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/cut/cut_step.h"
#include "core/document/document.h"
#include "core/document/stroke_path.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/render/view/camera.h"

namespace kerf {

// The entry of the emitter in the head of a document.
inline constexpr const char* kEmitterKey = "emitter";

// Returns the beam radius [m] of such an entry, which worlds from the game have.
std::optional<double> radius_of_entry(const nlohmann::json& entry);

struct ResolutionControls {
  Scheme scheme = Scheme::kLongestEdge;
  Resolution::Rule rule = Resolution::Rule::kTargetEdge;
  double edge_fraction = 0.25;        // target edge over radius, 1/32 .. 2
  double tolerance_fraction = 0.125;  // tolerance over radius, 1/32 .. 2
  int depth = 4;                      // levels, 0 .. kMaxDepth
  Rim rim = Rim::kSmooth;

  static constexpr double kMinFraction = 1.0 / 32, kMaxFraction = 2;
  static constexpr int kMaxDepth = 10;

  // Returns the resolution for a beam of this radius [m, > 0].
  Resolution of(double radius) const;
  // Sets the sliders to the resolution of a beam of this radius, within their range.
  void show(const Resolution& resolution, double radius);
};

// Refines by `steps`: each halves the fraction of the selected rule, or splits once more.
void make_finer(ResolutionControls& controls, int steps);

// The settings in the Laser panel, with which a stroke starts.
struct LaserControls {
  double radius = 0.01;          // m
  double default_radius = 0.01;  // m, 1/400 of the diagonal of the opened world
  ResolutionControls resolution;
  Pattern pattern = Pattern::kVolume;
  Model model = Model::kGeometric;
  double power = 2000;               // W, of the thermal model
  bool oxygen = false;               // likewise, see Assist
  std::optional<double> heat_width;  // m, set by the user (see CutSettings); nullopt: default_heat_width
  double metre = 1;                  // in the unit of the file, which the lengths here have
  double planned_speed = 0;          // m/s, of the next strokes if they are planned; 0: unknown

  static constexpr double kMinPower = 1, kMaxPower = 20'000;
  // Limit of the radius: the default divided or multiplied by this factor.
  static constexpr double kRadiusSpan = 20;

  double width_of_heat() const { return heat_width.value_or(standard_width_of_heat()); }
  double standard_width_of_heat() const { return default_heat_width(radius, metre); }

  // Returns the beam, with the default range.
  Laser beam() const {
    Laser laser;
    laser.radius = radius;
    laser.pattern = pattern;
    laser.power = power;
    laser.assist = oxygen ? Assist::kOxygen : Assist::kNone;
    return laser;
  }
  // Returns the settings of a cut in a world with this diagonal [m]; the range of the beam is ten diagonals.
  CutSettings settings(double diagonal) const;
  // Returns the commands that cut along strokes with these controls, except for the laser settings that a
  // stroke has itself; `with_knife`: by a beam of radius 0, like strokes that have this radius themselves.
  std::vector<Command> commands_of(std::span<const StrokePath> strokes, double diagonal,
                                   bool with_knife) const;
  // Sets the controls to the radius and the resolution of a stroke, within their range.
  void show(const CutSettings& settings);
  // Resets the lengths to the defaults of a world with this diagonal [m].
  void fit(double diagonal) {
    radius = default_radius = diagonal > 0 ? diagonal / 400 : 0.01;
    heat_width.reset();
  }
};

// The radius of the beam, and its display unit.
struct ShownRadius {
  double length;
  FileUnit unit;
};

// Draws the rows of a resolution, or only that of the edge length, tolerance or depth, or of the rim. Each
// returns true if anything changed.
bool resolution_rows(ResolutionControls& to, const ShownRadius& radius);
bool resolution_size_row(ResolutionControls& to, const ShownRadius& radius);
bool rim_row(ResolutionControls& to);

// Converts pointer motion into strokes. The emitter lies a little above and to the right of the eye. The
// beam aims at a point on the pointer's ray at a distance that is fixed when the stroke starts (that of the
// surface under the pointer, or of the camera's pivot), so that poses depend on the pointer alone and not on
// the progress of the cut. A surface at another distance is cut less than 0.4 degrees of the view's angle
// off the pointer, because the emitter is near the eye.
class LaserTool {
 public:
  // x and y of the pointer are as in CameraView::ray; `pixel` is the size of a pixel in y; `time` is the time
  // of the event [s] on a monotonic clock, which the poses of the stroke store. The document receives a
  // stroke once its beam hits a body, so that a miss leaves no history step and no command in the journal.
  // While time passes, bodies may move into the beam; the document then receives the stroke once the pointer
  // has moved farther than in a click, or at once if fire() began it.
  void press(Document& document, const CameraView& view, Vec2 pointer, const LaserControls& controls,
             double time);
  void move(Document& document, const CameraView& view, Vec2 pointer, double pixel, double time);
  // Begin and continue a stroke with given poses instead of the pointer's; the emitter is `distance` [m]
  // from its target. A turn to the opposite direction ends the stroke and begins another. Preconditions:
  // fire() is called while no stroke is drawn, the distance is positive, and directions are unit vectors.
  void fire(Document& document, const Pose& pose, double distance, const CutSettings& settings, double time);
  void carry_to(Document& document, const Pose& pose, double time);
  // Continues the emission of a stationary beam of the thermal model; called once per frame with the current
  // time. No-op while moves are queued; the next call then covers the missed time.
  void hold_beam(Document& document, double time);
  // Ends the stroke. Returns true if its beam hit no body.
  bool release(Document& document);
  // Sets whether bodies move by themselves; called once per frame.
  void follow_time(Document& document, bool passes);

  bool cutting() const { return cutting_; }
  // Returns true if the document has received the stroke being drawn. Other commands may end it there.
  bool has_begun() const { return cutting_ && held_.empty(); }
  // Returns true if the beam heats its target.
  bool emits() const { return has_begun() && settings_.model == Model::kThermal; }

  // Shows the beam of a stroke that is cut again, or that was not drawn with this tool: with the given
  // settings and at a distance of about `emitter` [m]. No-op while a stroke is drawn.
  void take_over(const CutSettings& settings, double emitter);
  // Records the pose that the cut has reached, which may lag behind the pointer. The beam is drawn there.
  void reach(const Pose& pose) { beam_ = pose; }
  // Finds the point where the beam strikes at that pose: the rim of its cut, or a surface behind it.
  void find_impact(const Document& document);
  // Returns the beam to draw while it is on, until the stroke has ended and its last move is cut.
  std::optional<BeamPicture> picture(const Document& document) const;

 private:
  void set_up(const CutSettings& settings);
  double distance_of_emitter(const World& world, const CameraView& view) const;
  Pose aim(const CameraView& view, Vec2 pointer) const;
  void begin(const Document& document, const CutSettings& settings, double time);
  void move_to(Document& document, const Pose& pose, double time);
  bool has_moved() const { return held_.size() > 1; }
  void begin_held(Document& document);

  bool cutting_ = false;
  std::vector<Command> held_;     // of the stroke, until it meets a body
  bool time_passes_ = false;      // bodies move by themselves
  bool is_fired_ = false;         // by fire(), not by the pointer
  double began_ = 0;              // s of the clock of `time`, start of the stroke
  double last_time_ = 0;          // s since began_, last pose passed to the document
  double focus_ = 1;              // m along the pointer's ray
  double emitter_ = 1;            // m, from the target back to the emitter
  double reach_ = 1;              // m along the beam
  double radius_ = 0.01;          // m
  double overshoot_ = 0.01;       // m, maximum distance from the beam to the rim that it burns
  Vec2 pointer_{0};               // at the last pose
  CutSettings settings_;          // of the stroke
  Pose pose_;                     // requested by the pointer
  Pose beam_;                     // reached by the cut
  std::optional<double> strike_;  // m along the beam
};

}  // namespace kerf
