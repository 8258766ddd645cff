#pragma once

#include "core/heat/material.h"

namespace kerf {

// How much denser a Gaussian beam of 1/e^2 radius w is along its axis, integrated over its passing, than the
// same power spread evenly over a width of 2 w: sqrt(8 / pi).
inline constexpr double kAxisFactor = 1.5957691216057308;

// The lumped heat balance of cutting (Steen and Mazumder, Laser Material Processing) with the heat that is
// conducted into the sheet: what is absorbed removes a kerf of constant width and heats what is beside it,
//
//   A P = kerf thickness speed density (enthalpy of removal) / axis + k thickness dT q(Pe),
//
// Pe = speed kerf / (4 a), a the diffusivity, dT from the ambient to the transition. A sheet parts where the
// axis of the beam has passed, which is `axis` times denser than the same power spread evenly over the kerf;
// so this forecasts what the thermal model of the cut simulates with a Gaussian beam of 1/e^2 radius kerf
// / 2.
struct LumpedCut {
  Substance substance;
  double power = 2000;        // W
  double wavelength = 0;      // m; 0 stands for that with which the material is usually cut
  double kerf = 0.2e-3;       // m, > 0
  double axis = kAxisFactor;  // >= 1; 1 for an even beam
  bool oxygen = false;  // what can burn does (see burning_heat), which takes from the enthalpy of removal
};

// The speed (m/s) that just cuts a sheet of this thickness (m, > 0); 0 if no speed at which the balance holds
// does (Pe < 0.01: there the losses of the surface and the border of the sheet matter).
double cutting_speed(const LumpedCut& cut, double thickness);
// The thickness (m) that is just cut at this speed (m/s, > 0); infinite where what burns does without the
// beam.
double cut_thickness(const LumpedCut& cut, double speed);

// The heat that a cylinder at constant temperature loses while it moves through a plate, less what the kerf
// that it removes had taken, over k h dT: the series of Bessel functions (q_net) at eleven points between
// which it is interpolated as a power within 0.5 %, below 0.01 that at 0.01, and above 8 in proportion to
// Pe^0.36 (the exponent of Schulz et al., Journal of Physics D 26, 1993). Precondition: peclet >= 0.
double conduction_loss(double peclet);

// What would have got a beam through a sheet that it did not get through: each of the three on its own, by
// the lumped heat balance.
struct CutRemedies {
  double speed = 0;  // m/s, slower; 0: no speed at which the balance holds is slow enough
  double power = 0;  // W, more
  double kerf = 0;   // m, narrower; 0: narrower alone would not do
};

// The remedies for a cut at a speed (m/s, > 0) through a sheet of this thickness (m, > 0, along the beam);
// nothing changes where the balance says that it gets through: all three are those of the cut. Constant time.
CutRemedies remedies(const LumpedCut& cut, double thickness, double speed);

}  // namespace kerf
