#pragma once

#include "core/laser/laser.h"
#include "core/world/world.h"

namespace kerf::test {

// A strip of a sheet that a beam crosses in the middle, at a constant speed.
struct LaserStrip {
  Substance substance;
  double thickness = 0.001;  // m
  double power = 1000;       // W
  double kerf = 2e-4;        // m; the radius of the beam is half of it
  double target_edge = 1;    // of the faces under the beam, in radii of the beam
  Assist assist = Assist::kNone;
};

// The world after the beam has crossed the strip at a speed (m/s). The strip is wide and long enough for a
// steady field around the beam.
World cross(const LaserStrip& strip, double speed);

// Whether what the crossing left is two large pieces.
bool is_in_two(const World& world);

// The highest speed (m/s) at which the strip falls in two, to 2 %; 0 if it does not at any from `slowest` on.
// Precondition: 0 < slowest.
double fastest_cut(const LaserStrip& strip, double slowest, double guess);

}  // namespace kerf::test
