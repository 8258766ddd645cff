#pragma once

#include "core/base/geometry.h"

namespace kerf {

// Light of a black-body surface. A grey surface has the same colour and, in proportion to its emissivity,
// less luminance.
struct Glow {
  Vec3 colour{0};            // linear sRGB, its largest component 1; black if invisible
  double log_luminance = 0;  // natural logarithm of the luminance in cd/m^2
};

// Range of temperatures (K): a surface below the Draper point is dark, and no material of a cut stays hotter
// than kGlowTo.
inline constexpr double kGlowFrom = 798;
inline constexpr double kGlowTo = 4000;

// Returns the glow at a temperature (K): black below kGlowFrom, constant above kGlowTo.
//
// The colour is Planck's law integrated with the CIE 1931 colour matching functions at 5 nm, in linear sRGB
// (D65), negative components clipped, within 1e-4 of the integral at 1 nm. The luminance is a fit to the same
// integral, ln Y = a + b u + c u^2 + d u^3 with u = 1000 K / T, within 0.1 %. Identical to the bit on every
// machine. Costs about 100 exponentials: use a table for many faces.
Glow glow_at(double temperature);

}  // namespace kerf
