#pragma once

#include <optional>

#include "core/cut/cut_step.h"
#include "core/document/stroke_settings.h"
#include "core/mesh/files/mesh_format.h"

namespace kerf {

// The values of the resolution's sliders.
struct ResolutionControls {
  Scheme scheme = Scheme::kLongestEdge;
  Resolution::Rule rule = Resolution::Rule::kTargetEdge;
  double edge_fraction = 0.25;        // target edge over radius, 1/32 .. 2
  double tolerance_fraction = 0.125;  // tolerance over radius, 1/32 .. 2
  int depth = 4;                      // levels, 0 .. kLargestDepth
  Rim rim = Rim::kSmooth;

  static constexpr double kMinFraction = 1.0 / 32, kMaxFraction = 2;
  static constexpr int kLargestDepth = 10;

  // The resolution for a beam of this radius (m, > 0).
  Resolution of(double radius) const;
  // Shows the resolution of a beam of this radius, as far as the sliders reach.
  void show(const Resolution& resolution, double radius);
};

// So many steps finer: a step halves the fraction of the rule that is chosen, or splits once more.
void make_finer(ResolutionControls& controls, int steps);

// The settings of the laser that its panel shows and a stroke starts with.
struct LaserControls {
  double radius = 0.01;          // m
  double default_radius = 0.01;  // m, D/400 of what was opened
  ResolutionControls resolution;
  Pattern pattern = Pattern::kVolume;
  Model model = Model::kGeometric;
  double power = 2000;               // W, of the thermal model
  bool oxygen = false;               // likewise, see Assist
  std::optional<double> heat_width;  // m, that was chosen (see CutSettings); none: default_heat_width
  double planned_speed = 0;  // m/s, of the next strokes as far as they are planned; 0: it is not known

  static constexpr double kMinPower = 1, kMaxPower = 20'000;
  // The radius is set from the default over this to the default times this.
  static constexpr double kRadiusSpan = 20;

  double width_of_heat() const { return heat_width.value_or(default_heat_width(radius)); }

  // The beam, with the usual range.
  Laser beam() const {
    Laser laser;
    laser.radius = radius;
    laser.pattern = pattern;
    laser.power = power;
    laser.assist = oxygen ? Assist::kOxygen : Assist::kNone;
    return laser;
  }
  // The settings of a cut in a world with this diagonal (m); the range of the beam is ten diagonals.
  CutSettings settings(double diagonal) const;
  // Shows the radius and the resolution of a stroke, as far as the sliders reach.
  void show(const CutSettings& settings);
  void fit(double diagonal) { radius = default_radius = diagonal > 0 ? diagonal / 400 : 0.01; }
};

// The radius of the beam, and the unit that it is shown in.
struct ShownRadius {
  double length;
  FileUnit unit;
};

// Rows of a panel for a resolution. Returns whether anything changed.
bool resolution_rows(ResolutionControls& to, const ShownRadius& radius);

}  // namespace kerf
