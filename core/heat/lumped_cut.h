#pragma once

#include "core/heat/material.h"

namespace kerf {

// Ratio of the energy density on the axis of a passing Gaussian beam of 1/e^2 radius w to that of the same
// power spread evenly over a width of 2 w: sqrt(8 / pi).
inline constexpr double kAxisFactor = 1.5957691216057308;

// The lumped heat balance of cutting (Steen and Mazumder, Laser Material Processing) with the heat conducted
// into the sheet. The absorbed power removes a kerf of constant width and heats the adjacent material,
//
//   A P = kerf thickness speed density (enthalpy of removal) / axis + k thickness dT q(Pe),
//
// where Pe = speed kerf / (4 a), a is the diffusivity, and dT is the difference between the transition and
// the ambient. A sheet is cut through on the axis of the beam, where the energy density is `axis` times that
// of the same power spread evenly over the kerf. The balance therefore predicts the results of the thermal
// model with a Gaussian beam of 1/e^2 radius kerf / 2.
struct LumpedCut {
  Substance substance;
  double power = 2000;        // W
  double wavelength = 0;      // m; 0 for the material's usual one
  double kerf = 0.2e-3;       // m, > 0
  double axis = kAxisFactor;  // >= 1; 1 for an even beam
  bool oxygen = false;        // combustion lowers the enthalpy of removal (see burning_heat)
};

// Returns the maximum speed (m/s) that cuts a sheet of this thickness (m, > 0); 0 if there is none in the
// range of the balance (at Pe < 0.01 the losses of the surface and the border of the sheet matter).
double cutting_speed(const LumpedCut& cut, double thickness);
// Returns the maximum thickness (m) cut at this speed (m/s, > 0); infinite if combustion alone suffices.
double cut_thickness(const LumpedCut& cut, double speed);

// Returns the heat that a cylinder at constant temperature loses while it moves through a plate, minus the
// heat contained in the removed kerf, over k h dT: the series of Bessel functions (q_net) at eleven points,
// interpolated as a power within 0.5 %; below 0.01 the value at 0.01, above 8 in proportion to Pe^0.36 (the
// exponent of Schulz et al., Journal of Physics D 26, 1993). Precondition: peclet >= 0.
double conduction_loss(double peclet);

// Changes each of which alone would make a failed cut succeed, by the lumped heat balance.
struct CutRemedies {
  double speed = 0;  // m/s, slower; 0 if no speed in the range of the balance is slow enough
  double power = 0;  // W, more; infinite if the sheet does not absorb the beam
  double kerf = 0;   // m, narrower; 0 if that alone does not suffice
};

// Returns the remedies for a cut at a speed (m/s, > 0) through a sheet of this thickness (m, > 0, along the
// beam); the values of the cut itself if the balance predicts success. O(1).
CutRemedies remedies(const LumpedCut& cut, double thickness, double speed);

}  // namespace kerf
