#pragma once

#include <optional>

#include "core/cut/cut_step.h"
#include "core/document/stroke_settings.h"
#include "core/mesh/files/mesh_format.h"

namespace kerf {

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
  double planned_speed = 0;          // m/s, of the next strokes if they are planned; 0: unknown

  static constexpr double kMinPower = 1, kMaxPower = 20'000;
  // The radius ranges from the default over this to the default times this.
  static constexpr double kRadiusSpan = 20;

  double width_of_heat() const { return heat_width.value_or(default_heat_width(radius)); }

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
  // Sets the controls to the radius and the resolution of a stroke, within their range.
  void show(const CutSettings& settings);
  void fit(double diagonal) { radius = default_radius = diagonal > 0 ? diagonal / 400 : 0.01; }
};

// The radius of the beam, and its display unit.
struct ShownRadius {
  double length;
  FileUnit unit;
};

// Draws the rows of a resolution. Returns true if anything changed.
bool resolution_rows(ResolutionControls& to, const ShownRadius& radius);

}  // namespace kerf
